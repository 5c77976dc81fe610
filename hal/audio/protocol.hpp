// What a controller and its sound program say to each other: one message, one packet of a local socket.
//
//   byte 0: kind. Then its fields in the order of hal/sound_output.hpp: numbers as this machine has them (both ends run
//   on it), flags as one byte, texts as a length of 32 bits and their bytes. Nothing may follow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hal/sound_output.hpp"

namespace darwinop::audio {

inline constexpr std::size_t kLongestText = 32'000;     // bytes: half an hour of speech
inline constexpr std::size_t kLongestMessage = 33'000;  // a socket's buffer holds some of them

using Message = std::vector<std::uint8_t>;

/// Texts that are too long are cut.
[[nodiscard]] Message encode(const SoundOrder& order);
[[nodiscard]] Message encode(const SoundNews& news);

/// Nothing for what is no message: too short, too long, a number out of its range, a NUL in a text.
[[nodiscard]] std::optional<SoundOrder> decodeOrder(std::span<const std::uint8_t> message);
[[nodiscard]] std::optional<SoundNews> decodeNews(std::span<const std::uint8_t> message);

}  // namespace darwinop::audio
