#include "core/text/number_text.hpp"

#include <array>

namespace darwinop::text {
namespace {

template <class... Format>
std::string textOf(double value, Format... format) {
  if (std::isnan(value)) return "nan";  // never "-nan"
  std::array<char, 400> text{};         // the largest number has 309 digits before the point
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value, format...).ptr};
}

}  // namespace

std::string fixedText(double value, int decimals) {
  return textOf(value, std::chars_format::fixed, decimals);
}

std::string generalText(double value, int digits) {
  return textOf(value, std::chars_format::general, digits);
}

std::string shortestText(double value) {
  return textOf(value);
}

std::string inSeconds(std::chrono::nanoseconds time) {
  return std::to_string(std::chrono::duration_cast<std::chrono::seconds>(time).count()) + " s";
}

}  // namespace darwinop::text
