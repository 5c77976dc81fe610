#include "hil-mocks/script_line.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <sstream>
#include <stdexcept>

namespace darwinop::hil {
namespace {

constexpr double kLongestSeconds = 1e6;

std::string textOf(double number) {
  std::ostringstream out;
  out << number;
  return out.str();
}

}  // namespace

ScriptLine::ScriptLine(std::string_view text, std::string_view file, std::size_t number)
    : rest_{text}, file_{file}, number_{number} {
  rest_ = rest_.substr(0, rest_.find('#'));
}

std::string_view ScriptLine::next() {
  constexpr std::string_view kBlank = " \t\r";
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlank), rest_.size()));
  word_ = rest_.substr(0, rest_.find_first_of(kBlank));
  rest_.remove_prefix(word_.size());
  return word_;
}

void ScriptLine::fail(const std::string& allowed) const {
  const std::string field = word_.empty() ? "end of line" : "field '" + std::string(word_) + "'";
  throw std::runtime_error(std::string(file_) + ":" + std::to_string(number_) + ": " + field + ": " + allowed);
}

double ScriptLine::number(std::string_view what, double low, double high) {
  const std::string_view word = next();
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !(value >= low && value <= high))
    fail(std::string(what) + " must be a number from " + textOf(low) + " to " + textOf(high));
  return value;
}

Nanos ScriptLine::time(std::string_view what, double low_s) {
  const std::chrono::duration<double> seconds{number(what, low_s, kLongestSeconds)};
  return std::chrono::duration_cast<Nanos>(seconds);
}

}  // namespace darwinop::hil
