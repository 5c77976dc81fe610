// Converts values of a page to and from text.
#include "managers/motion_text/values.hpp"

#include <charconv>
#include <cmath>

#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "core/text/number_text.hpp"
#include "managers/motion/page.hpp"

namespace darwinop::motion {

namespace {

// Slopes from 2^3 to 2^8: smaller ones saturate the register, larger ones make it 0, so they are not invertible.
constexpr unsigned kFirstSlope = 3, kLastSlope = 8;
constexpr std::uint8_t equalSlopes(unsigned slope) {
  return static_cast<std::uint8_t>(slope * 0x11U);
}

template <class Integer>
std::optional<Integer> integerFromText(std::string_view text, int base) {
  Integer value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string hexText(unsigned value, int digits) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text;
  while (digits-- > 0) text += kDigits[(value >> (4 * static_cast<unsigned>(digits))) & 15U];
  return text;
}

/// `text` in multiples of `unit`, rounded, if within 0 to `most`.
std::optional<int> nearest(std::string_view text, double unit, double zero, int most) {
  const auto number = text::numberFromText(text);
  if (!number) return std::nullopt;
  const double counts = std::nearbyint(*number / unit) + zero;
  if (!(counts >= 0 && counts <= most)) return std::nullopt;
  return static_cast<int>(counts);
}

}  // namespace

std::string angleText(std::uint16_t word) {
  if (word == kUnusedWord) return "keep";
  if (word > kTickMax) return "0x" + hexText(word, 4);
  return text::fixedText((word - kTickCentre) * kDegreesPerTick, 2);
}

std::optional<std::uint16_t> angleFromText(std::string_view text) {
  if (text == "keep") return kUnusedWord;
  if (text.starts_with("0x")) return integerFromText<std::uint16_t>(text.substr(2), 16);
  const auto ticks = nearest(text, kDegreesPerTick, kTickCentre, kTickMax);
  if (!ticks) return std::nullopt;
  return static_cast<std::uint16_t>(*ticks);
}

std::string secondsText(std::uint8_t units) {
  return text::fixedText(units * kSecondsPerUnit, 3);
}

std::optional<std::uint8_t> secondsFromText(std::string_view text) {
  const auto units = nearest(text, kSecondsPerUnit, 0, 255);
  if (!units) return std::nullopt;
  return static_cast<std::uint8_t>(*units);
}

std::string gainText(std::uint8_t slopes) {
  for (unsigned slope = kFirstSlope; slope <= kLastSlope; ++slope)
    if (slopes == equalSlopes(slope)) return std::to_string(pGainRegister(slopes));
  return "0x" + hexText(slopes, 2);
}

std::optional<std::uint8_t> gainFromText(std::string_view text) {
  if (text.starts_with("0x")) return integerFromText<std::uint8_t>(text.substr(2), 16);
  for (unsigned slope = kFirstSlope; slope <= kLastSlope; ++slope)
    if (text == std::to_string(pGainRegister(equalSlopes(slope)))) return equalSlopes(slope);
  return std::nullopt;
}

std::optional<std::uint8_t> countFromText(std::string_view text, int most) {
  const auto value = integerFromText<std::uint8_t>(text, 10);
  return value && *value <= most ? value : std::nullopt;
}

std::string byteText(std::uint8_t value) {
  return hexText(value, 2);
}

std::optional<std::uint8_t> byteFromText(std::string_view text) {
  return text.size() == 2 ? integerFromText<std::uint8_t>(text, 16) : std::nullopt;
}

bool isJoint(std::size_t id) {
  return id >= 1 && id <= kJoints;
}

std::string servoText(std::size_t id) {
  return isJoint(id) ? std::string{kJointTable.at(id - 1).name} : "id " + std::to_string(id);
}

std::optional<std::size_t> servoFromText(std::string_view text) {
  for (std::size_t id = 0; id < kServos; ++id)
    if (servoText(id) == text) return id;
  return std::nullopt;
}

}  // namespace darwinop::motion
