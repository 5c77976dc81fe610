// Reads and writes numbers with units, and suggests the conversion for another unit.
#include "twin/model/number.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/text/letter_case.hpp"
#include "core/text/number_text.hpp"
#include "core/text/unit_factor.hpp"
#include "twin/model/messages.hpp"

namespace darwinop::twin {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::string_view kNone = "none";

/// Shortest exact text; without an exponent if that fits in 10 characters.
std::string shortest(double value) {
  constexpr std::size_t kShort = 10;
  std::array<char, kShort> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + kShort, value, std::chars_format::fixed);
  return error == std::errc{} ? std::string{text.data(), end} : text::shortestText(value);
}

std::string withUnit(std::string number, std::string_view unit) {
  if (!unit.empty()) (number += ' ') += unit;
  return number;
}

[[noreturn]] void refuse(const std::string& message) {
  throw std::runtime_error(message);
}

/// Collapses runs of blanks.
std::string squeezed(std::string_view text) {
  std::string out;
  for (const char c : text::withoutBlanks(text)) {
    const bool blank = c == ' ' || c == '\t';
    if (!blank || out.back() != ' ') out += blank ? ' ' : c;
  }
  return out;
}

std::string lettersOf(std::string_view unit) {
  constexpr std::string_view kBetween = " *^()\xc2\xb7";  // the last two bytes are a middle dot in UTF-8
  std::string out;
  for (const char c : unit)
    if (kBetween.find(c) == kBetween.npos) out += c;
  return text::lowered(out);
}

[[noreturn]] void refuseUnit(double value, const std::string& unit, const NumberRule& rule) {
  std::string message = rule.unit.empty() ? "this is a pure number, without the unit " + unit
                                          : "the unit is " + std::string{rule.unit} + ", not " + unit;
  if (const auto factor = text::unitFactor(unit, rule.unit))
    message += "; write " + withUnit(text::generalText(value * *factor, 6), rule.unit);
  else if (!rule.unit.empty() && lettersOf(unit) == lettersOf(rule.unit))
    message += "; write " + withUnit(shortest(value), rule.unit);
  else
    message += "; give " + allowed(rule);
  refuse(message);
}

/// True for a character that may follow a number directly: blank, letter, per cent or degree sign (UTF-8).
bool beginsUnit(char c) {
  return c == ' ' || c == '\t' || c == '%' || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
         static_cast<unsigned char>(c) >= 0x80;
}

void checkRange(double value, const NumberRule& rule) {
  if (!(value >= rule.low && value <= rule.high)) refuse(messages::kOutOfRange + allowed(rule));
}

}  // namespace

std::string allowed(const NumberRule& rule) {
  const auto end = [&](double value) { return withUnit(shortest(value), rule.unit); };
  std::string text;
  if (std::isfinite(rule.low) && std::isfinite(rule.high))
    text = shortest(rule.low) + " to " + end(rule.high);
  else if (std::isfinite(rule.low))
    text = end(rule.low) + " or more";
  else if (std::isfinite(rule.high))
    text = end(rule.high) + " or less";
  else
    text = withUnit("any number", rule.unit.empty() ? "" : "of " + std::string{rule.unit});
  return text + (rule.may_be_none ? ", or none for no limit" : "");
}

double readNumber(std::string_view text, const NumberRule& rule) {
  text = text::withoutBlanks(text);
  if (text::lowered(text) == kNone) {
    if (rule.may_be_none) return kInfinity;
    refuse("none is not allowed here; give " + allowed(rule));
  }
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view rest{end, text.data() + text.size()};
  if (error == std::errc::result_out_of_range) refuse(messages::kOutOfRange + allowed(rule));
  if (error != std::errc{} || (!rest.empty() && !beginsUnit(rest.front())))
    refuse("not a number; give " + allowed(rule) + (rest.starts_with(',') ? ", with a point for decimals" : ""));
  if (!std::isfinite(value)) refuse("not a finite number; give " + allowed(rule));
  const std::string unit = squeezed(rest);
  if (unit.empty() && !rule.unit.empty()) refuse("the unit is missing; write " + withUnit(shortest(value), rule.unit));
  if (unit != rule.unit) refuseUnit(value, unit, rule);
  checkRange(value, rule);
  return value;
}

std::array<double, 3> readAxes(std::string_view text, const NumberRule& rule) {
  const auto first = text.find(','), second = first == text.npos ? text.npos : text.find(',', first + 1);
  if (second != text.npos && text.find(',', second + 1) == text.npos) {
    const auto x = text::numberFromText(text.substr(0, first));
    const auto y = text::numberFromText(text.substr(first + 1, second - first - 1));
    if (x && y) {
      const double z = readNumber(text.substr(second + 1), rule);
      for (const double value : {*x, *y}) checkRange(value, rule);
      return {*x, *y, z};
    }
  }
  refuse("give three numbers, for the axes x, y and z, as in " + writeAxes({rule.low, 0, rule.high}, rule));
}

std::string writeNumber(double value, const NumberRule& rule) {
  return rule.may_be_none && value == kInfinity ? std::string{kNone} : withUnit(shortest(value), rule.unit);
}

std::string writeAxes(const std::array<double, 3>& values, const NumberRule& rule) {
  return withUnit(shortest(values[0]) + ", " + shortest(values[1]) + ", " + shortest(values[2]), rule.unit);
}

}  // namespace darwinop::twin
