// Keyboard map of the X server.
#pragma once

#include <xcb/xcb.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hal/keyboard.hpp"

namespace darwinop::x11 {

class KeyMap {
 public:
  /// Queries the server; call again after a mapping event.
  explicit KeyMap(xcb_connection_t* connection);

  [[nodiscard]] std::optional<Key> key(xcb_keycode_t code, bool num_lock) const;
  [[nodiscard]] Key modifier(xcb_keycode_t code) const;
  /// False: the server did not answer.
  [[nodiscard]] bool isKnown() const { return per_key_ > 0; }

 private:
  [[nodiscard]] std::span<const std::uint32_t> keysyms(xcb_keycode_t code) const;

  xcb_keycode_t first_ = 0;
  std::size_t per_key_ = 0;
  std::vector<std::uint32_t> keysyms_;
};

/// The server's key state; nothing if it does not answer in time. During auto-repeat the events report releases, but
/// this state stays pressed.
[[nodiscard]] std::optional<bool> isDown(xcb_connection_t* connection, xcb_keycode_t code);

}  // namespace darwinop::x11
