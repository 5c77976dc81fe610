// Numbers from and to text, the same in every locale.
#pragma once

#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace darwinop::text {

constexpr std::string_view withoutBlanks(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n\v\f";
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// The whole text as one finite number, or nothing.
inline std::optional<double> numberFromText(std::string_view text) {
  text = withoutBlanks(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// With `decimals` digits after the point: "%.*f" of printf. NaN is "nan".
std::string fixedText(double value, int decimals);
/// With at most `digits` significant digits: "%.*g" of printf.
std::string generalText(double value, int digits);
/// The shortest text that reads back as the same number.
std::string shortestText(double value);

/// Whole seconds, cut: "5 s".
std::string inSeconds(std::chrono::nanoseconds time);

}  // namespace darwinop::text
