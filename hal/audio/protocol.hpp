// Messages between a controller and its sound process; one packet of a local socket each.
//
//   byte 0: kind, then the fields in the order of hal/sound_output.hpp: numbers in native byte order (both ends run on
//   one machine), flags as one byte, texts as a 32-bit length and their bytes. Nothing follows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hal/sound_output.hpp"

namespace darwinop::audio {

inline constexpr std::size_t kLongestText = 32'000;     // bytes, about half an hour of speech
inline constexpr std::size_t kLongestVoice = 100;       // bytes
inline constexpr std::size_t kLongestMessage = 33'000;  // bytes; a socket buffer holds several

using Message = std::vector<std::uint8_t>;

/// Truncates texts longer than kLongestText, and voices.
[[nodiscard]] Message encode(const SoundOrder& order);
[[nodiscard]] Message encode(const SoundEvent& event);

/// Empty if malformed: too short, too long, a number out of range, a NUL in a text.
[[nodiscard]] std::optional<SoundOrder> decodeOrder(std::span<const std::uint8_t> message);
[[nodiscard]] std::optional<SoundEvent> decodeEvent(std::span<const std::uint8_t> message);

}  // namespace darwinop::audio
