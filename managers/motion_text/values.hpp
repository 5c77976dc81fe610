// The values of a page as words of the text, and back: degrees, seconds, gains; hexadecimal where these say too little.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace darwinop::motion {

inline constexpr double kSecondsPerUnit = 0.008;  // of times, pauses and the acceleration
inline constexpr double kDegreesPerTick = 360.0 / 4096.0;

/// `value` with so many digits behind the point; the same in every locale.
[[nodiscard]] std::string fixed(double value, int digits);

/// Ticks as degrees with two digits, of which the nearest tick is again the same. "keep" is the word that the
/// vendor's editor writes for a joint that is not part of a step; any other word is written as it is: 0x4000.
[[nodiscard]] std::string angleText(std::uint16_t word);
[[nodiscard]] std::optional<std::uint16_t> angleFromText(std::string_view text);

/// 0 to 2.040 s; what lies between two units goes to the nearest.
[[nodiscard]] std::string secondsText(std::uint8_t units);
[[nodiscard]] std::optional<std::uint8_t> secondsFromText(std::string_view text);

/// The P gain register of a servo with both slopes alike (4, 8 ... 128), any other pair of slopes as it is: 0x57.
[[nodiscard]] std::string gainText(std::uint8_t slopes);
[[nodiscard]] std::optional<std::uint8_t> gainFromText(std::string_view text);

/// A whole number from 0 to `most`, in decimals.
[[nodiscard]] std::optional<std::uint8_t> countFromText(std::string_view text, int most = 255);
/// Two hexadecimal digits.
[[nodiscard]] std::string byteText(std::uint8_t value);
[[nodiscard]] std::optional<std::uint8_t> byteFromText(std::string_view text);

/// What stands at the place of servo `id` in a page: a joint's name, or "id 21" where there is none.
[[nodiscard]] std::string servoText(std::size_t id);
[[nodiscard]] std::optional<std::size_t> servoFromText(std::string_view text);
[[nodiscard]] bool isJoint(std::size_t id);

}  // namespace darwinop::motion
