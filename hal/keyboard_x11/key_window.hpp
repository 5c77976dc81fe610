// A small window: the keys that are pressed while it has the focus.
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

/// Made and run by one thread, which waits for the X server. libxcb and not libX11: libX11 ends the process when the
/// server goes away, and cannot be linked into a static program without what looks up hosts and loads libraries.
class KeyWindow {
 public:
  enum class End : std::uint8_t { kStopped, kClosed, kServerGone };

  /// `display`: the text of DISPLAY. `keys` must outlive it. Throws std::runtime_error: there is no window, and why.
  KeyWindow(HeldKeys& keys, const std::string& display);

  /// Until `stop_fd` can be read, the user closes the window, or the server goes away. No key is down then, nor
  /// when the server has not answered for a second.
  End run(int stop_fd);

 private:
  void make();
  void name();
  /// Without a window manager nobody else gives a window the focus.
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
  Picture picture_;
  xcb_atom_t delete_window_ = XCB_NONE;
  std::optional<unsigned> asked_;  // number of a question that the server has not answered yet
  bool focused_ = false, changed_ = true, closed_ = false;
};

}  // namespace darwinop::x11
