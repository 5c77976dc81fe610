// Masks readings outside the physical range of their column, and counts what is missing.
#include "gap/case/column_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/units.hpp"
#include "gap/case/bad_rows.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

constexpr double kTwoTurns = 4 * kPi;
// Registers of load end at 1000 or 1023 counts of 0.1 %.
const std::array kColumnBounds{
    ColumnBounds{&Trajectory::position_rad,
                 "pos",
                 "rad",
                 -kTwoTurns,
                 kTwoTurns,
                 1,
                 {{{kPi / 180, "are these degrees? name the column pos_deg then"}, {0, ""}}}},
    ColumnBounds{&Trajectory::speed_rad_s,
                 "speed",
                 "rad/s",
                 -100,
                 100,
                 1,
                 {{{kRadPerSecPerRpm, "are these rpm? name the column speed_rpm then"},
                   {kPi / 180, "are these degrees? name the column speed_deg_s then"}}}},
    ColumnBounds{&Trajectory::load, "load", "%", -1.03, 1.03, 100, {{{100.0 / 2047, messages::kRawCounts}, {0, ""}}}},
    ColumnBounds{&Trajectory::volt_v, "volt", "V", 3, 30, 1, {{{0.1, messages::kRawCounts}, {0, ""}}}},
    ColumnBounds{&Trajectory::temp_c, "temp", "degC", -20, 100, 1, {{{0, ""}, {0, ""}}}},
};

std::string sixDigits(double value) {
  char text[32];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.6g", value))};
}

/// A unit in which all of the readings would be possible; a lone fault has none.
std::string_view adviceFor(const ColumnBounds& of, const std::vector<double>& values) {
  for (const OtherUnit& other : of.others) {
    const auto fits = [&](double value) {
      return std::isnan(value) || (value * other.factor >= of.low && value * other.factor <= of.high);
    };
    if (other.factor != 0 && std::ranges::all_of(values, fits)) return other.advice;
  }
  return "check the cable and the unit, and measure again";
}

}  // namespace

std::span<const ColumnBounds> columnBounds() {
  return kColumnBounds;
}

bool areFew(std::size_t some, std::size_t all) {
  return static_cast<double>(some) <= kMostMasked * static_cast<double>(all);
}

void mask(Trajectory& log, const ColumnBounds& of, std::vector<std::size_t> rows, std::string_view why) {
  std::erase_if(rows, [&](std::size_t row) { return std::isnan((log.*of.values)[row]); });
  if (rows.empty()) return;
  for (const std::size_t row : rows) (log.*of.values)[row] = std::numeric_limits<double>::quiet_NaN();
  log.masked.push_back({.column = of.column, .why = why, .rows = rows.size(), .first_line = log.lines[rows.front()]});
}

void maskOutOfRange(Trajectory& log, const std::string& file, const ColumnBounds& of) {
  const std::vector<double>& values = log.*of.values;
  std::vector<std::size_t> outside;
  for (std::size_t row = 0; row < values.size(); ++row)
    if (values[row] < of.low || values[row] > of.high) outside.push_back(row);
  if (!areFew(outside.size(), values.size()))
    throw BadInput(file + ", line " + std::to_string(log.lines[outside.front()]) + ": " + std::string{of.column} +
                   " is " + sixDigits(values[outside.front()] * of.shown) + " " + std::string{of.unit} +
                   messages::kOutsideServoRange + sixDigits(of.low * of.shown) + " to " +
                   sixDigits(of.high * of.shown) + "), as in " + std::to_string(outside.size()) + " of " +
                   std::to_string(values.size()) + " rows; " + std::string{adviceFor(of, values)});
  mask(log, of, outside, messages::kMaskedRange);
}

void noteEmptyPositions(Trajectory& log, const std::string& file) {
  MaskedReadings empty{.column = kColumnBounds[kPos].column, .why = messages::kMaskedMissing};
  for (std::size_t row = 0; row < log.rows(); ++row)
    if (std::isnan(log.position_rad[row]) && ++empty.rows == 1) empty.first_line = log.lines[row];
  if (!areFew(empty.rows, log.rows()))
    throw BadInput(file + ", line " + std::to_string(empty.first_line) + ": pos is empty, as in " +
                   std::to_string(empty.rows) + " of " + std::to_string(log.rows()) +
                   " rows; leave rows out that were not measured");
  if (empty.rows > 0) log.masked.push_back(empty);
}

void refuseManyMasked(const Trajectory& log, const std::string& file) {
  for (const ColumnBounds& of : kColumnBounds) {
    std::size_t rows = 0;
    for (const MaskedReadings& masked : log.masked)
      if (masked.column == of.column) rows += masked.rows;
    if (!areFew(rows, log.rows()))
      throw BadInput(file + ": " + std::string{of.column} + messages::kManyMasked + std::to_string(rows) + " of " +
                     std::to_string(log.rows()) + " rows (" +
                     sixDigits(std::round(1000 * static_cast<double>(rows) / static_cast<double>(log.rows())) / 10) +
                     " %); check the cable and measure again");
  }
}

}  // namespace darwinop::gap
