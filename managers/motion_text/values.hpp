// Converts values of a page to and from text: degrees, seconds, gains; hexadecimal where these are not lossless.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace darwinop::motion {

inline constexpr double kSecondsPerUnit = 0.008;  // of times, pauses and the acceleration
inline constexpr double kDegreesPerTick = 360.0 / 4096.0;

/// Ticks as degrees with two digits, which round back to the same tick. "keep" is the vendor's word for a joint that is
/// not part of a step; any other word is hexadecimal: 0x4000.
[[nodiscard]] std::string angleText(std::uint16_t word);
[[nodiscard]] std::optional<std::uint16_t> angleFromText(std::string_view text);

/// 0 to 2.040 s, rounded to units of 8 ms.
[[nodiscard]] std::string secondsText(std::uint8_t units);
[[nodiscard]] std::optional<std::uint8_t> secondsFromText(std::string_view text);

/// The P gain register for equal slopes (4, 8 ... 128), any other pair of slopes as hexadecimal: 0x57.
[[nodiscard]] std::string gainText(std::uint8_t slopes);
[[nodiscard]] std::optional<std::uint8_t> gainFromText(std::string_view text);

/// A decimal integer from 0 to `most`.
[[nodiscard]] std::optional<std::uint8_t> countFromText(std::string_view text, int most = 255);
/// Two hexadecimal digits.
[[nodiscard]] std::string byteText(std::uint8_t value);
[[nodiscard]] std::optional<std::uint8_t> byteFromText(std::string_view text);

/// Name of servo `id`: a joint name, or "id 21".
[[nodiscard]] std::string servoText(std::size_t id);
[[nodiscard]] std::optional<std::size_t> servoFromText(std::string_view text);
[[nodiscard]] bool isJoint(std::size_t id);

}  // namespace darwinop::motion
