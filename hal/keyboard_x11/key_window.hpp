// X11 window that reads the keys pressed while it has the focus.
#pragma once

#include <xcb/xcb.h>

#include <cstdint>
#include <optional>
#include <string>

#include "hal/held_keys.hpp"
#include "hal/keyboard_x11/display.hpp"
#include "hal/keyboard_x11/key_map.hpp"
#include "hal/keyboard_x11/picture.hpp"

namespace darwinop::x11 {

/// Created and run by one thread, which blocks on the X server. Uses libxcb: libX11 ends the process when the server
/// closes, and cannot be linked statically without a resolver and dynamic loading.
class KeyWindow {
 public:
  enum class End : std::uint8_t { kStopped, kClosed, kServerGone };

  /// `display`: the text of DISPLAY. `keys` must outlive it. Throws std::runtime_error with the reason.
  KeyWindow(HeldKeys& keys, const std::string& display);

  /// Returns when `stop_fd` is readable, the user closes the window, or the server closes. No key is down then, nor
  /// after one second without a reply of the server.
  End run(int stop_fd);

 private:
  void make();
  void name();
  /// Without a window manager the window must take the focus itself.
  void takeFocusIfNobodyHasIt();
  void askWhetherItIsThere();
  [[nodiscard]] bool handleAll();
  void handle(const xcb_generic_event_t& event);
  void handlePress(const xcb_key_press_event_t& event);
  void handleRelease(const xcb_key_release_event_t& event);
  void setFocus(bool focused, std::uint8_t detail);
  void draw();

  HeldKeys& keys_;
  DisplayName display_;
  Connection connection_;
  const xcb_screen_t& screen_;
  xcb_window_t window_;
  KeyMap map_;
  KeyWindowCanvas picture_;
  xcb_atom_t delete_window_ = XCB_NONE;
  std::optional<unsigned> asked_;  // sequence number of a pending request
  bool focused_ = false, changed_ = true, closed_ = false;
};

}  // namespace darwinop::x11
