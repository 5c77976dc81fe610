// The text of a model file: one number changed, and the words of its comments.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "twin/model/model.hpp"

namespace darwinop::gap {

/// `text` with another number for `key` of [section], and what it was behind it, before the comment that the line had.
/// No other line changes. Throws std::runtime_error for what is no such number, or out of its range.
std::string withNumber(std::string_view text, std::string_view section, const std::string& key, double value);

/// The same with the numbers of x, y and z.
std::string withAxes(std::string_view text, std::string_view section, const std::string& key,
                     const std::array<double, 3>& values);

/// A number of [servo] of two models that is not the same in both.
struct MovedNumber {
  std::string key, unit;
  double before = 0, after = 0;
};
std::vector<MovedNumber> movedNumbers(const twin::ServoParameters& before, const twin::ServoParameters& after);

/// Comments in lines that a model file may have.
std::vector<std::string> wrapped(const std::vector<std::string>& comments);

/// More digits than a fit determines, few enough to read. Counts and seeds stay.
double forReading(double value);
/// Four digits: "0.0812 N m".
std::string withUnit(double value, std::string_view unit);
/// "0.0781 to 0.0853 N m".
std::string interval(double low, double high, std::string_view unit);

}  // namespace darwinop::gap
