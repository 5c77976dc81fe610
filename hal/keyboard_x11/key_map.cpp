#include "hal/keyboard_x11/key_map.hpp"

#include "hal/keyboard_x11/keysym.hpp"
#include "hal/keyboard_x11/reply.hpp"

namespace darwinop::x11 {

KeyMap::KeyMap(xcb_connection_t* connection) {
  const xcb_setup_t* const setup = ::xcb_get_setup(connection);
  first_ = setup->min_keycode;
  const auto count = static_cast<std::uint8_t>(setup->max_keycode - setup->min_keycode + 1);
  const auto asked = ::xcb_get_keyboard_mapping(connection, first_, count);
  const auto reply = replyInTime<xcb_get_keyboard_mapping_reply_t>(connection, asked.sequence);
  if (!reply) return;
  per_key_ = reply->keysyms_per_keycode;
  const xcb_keysym_t* const keysyms = ::xcb_get_keyboard_mapping_keysyms(reply.get());
  keysyms_.assign(keysyms, keysyms + ::xcb_get_keyboard_mapping_keysyms_length(reply.get()));
}

std::span<const std::uint32_t> KeyMap::keysyms(xcb_keycode_t code) const {
  const std::size_t begin = static_cast<std::size_t>(code - first_) * per_key_;
  if (code < first_ || begin + per_key_ > keysyms_.size()) return {};
  return std::span{keysyms_}.subspan(begin, per_key_);
}

std::optional<Key> KeyMap::key(xcb_keycode_t code, bool num_lock) const {
  return keyOfKeysyms(keysyms(code), num_lock);
}

Key KeyMap::modifier(xcb_keycode_t code) const {
  const auto all = keysyms(code);
  return all.empty() ? 0 : modifierOfKeysym(all.front());
}

std::optional<bool> isDown(xcb_connection_t* connection, xcb_keycode_t code) {
  const auto reply = replyInTime<xcb_query_keymap_reply_t>(connection, ::xcb_query_keymap(connection).sequence);
  if (!reply) return std::nullopt;
  return (reply->keys[code / 8U] & (1U << (code % 8U))) != 0;
}

}  // namespace darwinop::x11
