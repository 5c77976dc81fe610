#include "hal/keyboard_x11/key_window.hpp"

#include <poll.h>
#include <xcb/xcbext.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

#include "hal/keyboard_x11/keysym.hpp"
#include "hal/keyboard_x11/reply.hpp"

namespace darwinop::x11 {
namespace {

constexpr int kAskMs = 500;
constexpr std::string_view kTitle = "darwinop: keys for the robot";
constexpr std::string_view kClass{"darwinop-keys\0darwinop", 22};  // instance and class, as X11 wants them

const xcb_screen_t& screenOf(xcb_connection_t* connection, int number) {
  auto all = ::xcb_setup_roots_iterator(::xcb_get_setup(connection));
  for (; number > 0 && all.rem > 1; --number) ::xcb_screen_next(&all);
  return *all.data;
}

xcb_atom_t atom(xcb_connection_t* connection, std::string_view name) {
  const auto asked = ::xcb_intern_atom(connection, 0, static_cast<std::uint16_t>(name.size()), name.data());
  const Reply<xcb_intern_atom_reply_t> reply{::xcb_intern_atom_reply(connection, asked, nullptr)};
  return reply ? reply->atom : static_cast<xcb_atom_t>(XCB_NONE);
}

template <class Event>
const Event& as(const xcb_generic_event_t& event) {
  return reinterpret_cast<const Event&>(event);
}

}  // namespace

KeyWindow::KeyWindow(HeldKeys& keys, const std::string& display)
    : keys_{keys},
      display_{parseDisplay(display)},
      connection_{connectTo(display_)},
      screen_{screenOf(connection_.get(), display_.screen)},
      window_{::xcb_generate_id(connection_.get())},
      map_{connection_.get()},
      picture_{(make(), connection_.get()), screen_, window_} {
  name();
  ::xcb_map_window(connection_.get(), window_);
  ::xcb_flush(connection_.get());
}

void KeyWindow::make() {
  const std::array<std::uint32_t, 2> values{
      screen_.white_pixel, XCB_EVENT_MASK_KEY_PRESS | XCB_EVENT_MASK_KEY_RELEASE | XCB_EVENT_MASK_FOCUS_CHANGE |
                               XCB_EVENT_MASK_EXPOSURE | XCB_EVENT_MASK_STRUCTURE_NOTIFY | XCB_EVENT_MASK_BUTTON_PRESS};
  ::xcb_create_window(connection_.get(), XCB_COPY_FROM_PARENT, window_, screen_.root, 0, 0, KeyWindowCanvas::kWidth,
                      KeyWindowCanvas::kHeight, 0, XCB_WINDOW_CLASS_INPUT_OUTPUT, screen_.root_visual,
                      XCB_CW_BACK_PIXEL | XCB_CW_EVENT_MASK, values.data());
}

void KeyWindow::name() {
  xcb_connection_t* const to = connection_.get();
  const auto set_text = [&](xcb_atom_t property, std::string_view text) {
    ::xcb_change_property(to, XCB_PROP_MODE_REPLACE, window_, property, XCB_ATOM_STRING, 8,
                          static_cast<std::uint32_t>(text.size()), text.data());
  };
  set_text(XCB_ATOM_WM_NAME, kTitle);
  set_text(XCB_ATOM_WM_CLASS, kClass);
  // ICCCM WM_HINTS: flag 1 marks the input field as valid; input 1 requests the keyboard focus.
  constexpr std::array<std::uint32_t, 9> kHints{1, 1};
  ::xcb_change_property(to, XCB_PROP_MODE_REPLACE, window_, XCB_ATOM_WM_HINTS, XCB_ATOM_WM_HINTS, 32, kHints.size(),
                        kHints.data());
  delete_window_ = atom(to, "WM_DELETE_WINDOW");
  ::xcb_change_property(to, XCB_PROP_MODE_REPLACE, window_, atom(to, "WM_PROTOCOLS"), XCB_ATOM_ATOM, 32, 1,
                        &delete_window_);
}

void KeyWindow::takeFocusIfNobodyHasIt() {
  xcb_connection_t* const to = connection_.get();
  const auto now = replyInTime<xcb_get_input_focus_reply_t>(to, ::xcb_get_input_focus(to).sequence);
  if (now && (now->focus == XCB_NONE || now->focus == XCB_INPUT_FOCUS_POINTER_ROOT || now->focus == screen_.root))
    ::xcb_set_input_focus(to, XCB_INPUT_FOCUS_POINTER_ROOT, window_, XCB_CURRENT_TIME);
}

KeyWindow::End KeyWindow::run(int stop_fd) {
  std::array<pollfd, 2> files{{{stop_fd, POLLIN, 0}, {::xcb_get_file_descriptor(connection_.get()), POLLIN, 0}}};
  End end = End::kStopped;
  for (;;) {
    // Synchronous requests also queue events: check the queue again before waiting.
    while (handleAll() || changed_) draw();
    if (closed_) end = End::kClosed;
    if (::xcb_connection_has_error(connection_.get()) != 0) end = End::kServerGone;
    if (end != End::kStopped) break;
    const int ready = ::poll(files.data(), files.size(), keys_.down().empty() ? -1 : kAskMs);
    if (ready < 0 && errno != EINTR) break;
    if (ready > 0 && files[0].revents != 0) break;
    if (ready == 0) askWhetherItIsThere();
  }
  keys_.releaseAll();
  return end;
}

/// Polls the server while keys are down: over a stalled network the releases would be missed.
void KeyWindow::askWhetherItIsThere() {
  if (asked_) {
    keys_.releaseAll();
    changed_ = true;
  } else {
    asked_ = ::xcb_get_input_focus(connection_.get()).sequence;
    ::xcb_flush(connection_.get());
  }
}

/// Returns true if events were processed.
bool KeyWindow::handleAll() {
  bool any = false;
  void* answer = nullptr;
  if (asked_ && ::xcb_poll_for_reply(connection_.get(), *asked_, &answer, nullptr) == 1) asked_.reset();
  std::free(answer);
  for (;;) {
    const Reply<xcb_generic_event_t> event{::xcb_poll_for_event(connection_.get())};
    if (!event) return any;
    handle(*event);
    any = true;
  }
}

void KeyWindow::handle(const xcb_generic_event_t& event) {
  constexpr unsigned kSentByAProgram = 0x80;
  switch (event.response_type & ~kSentByAProgram) {
    case XCB_KEY_PRESS:
      return handlePress(as<xcb_key_press_event_t>(event));
    case XCB_KEY_RELEASE:
      return handleRelease(as<xcb_key_release_event_t>(event));
    case XCB_FOCUS_IN:
      return setFocus(true, as<xcb_focus_in_event_t>(event).detail);
    case XCB_FOCUS_OUT:
      return setFocus(false, as<xcb_focus_out_event_t>(event).detail);
    case XCB_MAP_NOTIFY:
    case XCB_BUTTON_PRESS:
      return takeFocusIfNobodyHasIt();
    case XCB_EXPOSE:
      changed_ = true;
      return;
    case XCB_MAPPING_NOTIFY:
      if (KeyMap map{connection_.get()}; map.isKnown()) map_ = std::move(map);
      return;
    case XCB_CLIENT_MESSAGE:
      closed_ = closed_ || as<xcb_client_message_event_t>(event).data.data32[0] == delete_window_;
      return;
    case XCB_DESTROY_NOTIFY:
      closed_ = true;
      return;
    default:
      return;
  }
}

void KeyWindow::handlePress(const xcb_key_press_event_t& event) {
  const Key modifiers = modifiersOfState(event.state);
  if (const Key own = map_.modifier(event.detail); own != 0)
    keys_.setModifiers(modifiers | own);
  else if (const auto key = map_.key(event.detail, numLockOfState(event.state)))
    keys_.press(event.detail, *key, modifiers);
  changed_ = true;
}

void KeyWindow::handleRelease(const xcb_key_release_event_t& event) {
  if (const Key own = map_.modifier(event.detail); own != 0)
    keys_.setModifiers(modifiersOfState(event.state) & ~own);
  else if (const std::optional<bool> down = isDown(connection_.get(), event.detail); !down)
    keys_.releaseAll();  // the releases of the others may be lost
  else if (!*down)
    keys_.release(event.detail);
  changed_ = true;
}

void KeyWindow::setFocus(bool focused, std::uint8_t detail) {
  // The pointer's window or a child window: the focus itself did not move.
  if (detail == XCB_NOTIFY_DETAIL_POINTER || detail == XCB_NOTIFY_DETAIL_INFERIOR) return;
  if (!focused) keys_.releaseAll();  // without focus there are no release events
  focused_ = focused;
  changed_ = true;
}

void KeyWindow::draw() {
  if (!changed_) return;
  changed_ = false;
  std::string names;
  for (const Key key : keys_.down()) names += (names.empty() ? "" : "  ") + keyName(key);
  picture_.draw(focused_, names);
  ::xcb_flush(connection_.get());
}

}  // namespace darwinop::x11
