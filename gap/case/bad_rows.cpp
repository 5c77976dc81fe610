// Masks readings that contradict their neighbours, by physical bounds: no reading is judged by how rare it is.
#include "gap/case/bad_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "core/units.hpp"
#include "gap/case/chain.hpp"
#include "gap/case/limits.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/plausible.hpp"

namespace darwinop::gap {
namespace {

constexpr double kMasked = std::numeric_limits<double>::quiet_NaN();
constexpr double kReadingSteps = 4;  // of the encoder: rounding and noise of two readings

/// A unit that the whole column may be in instead.
struct OtherUnit {
  double factor;  // to the unit in the name of the column
  std::string_view advice;
};
struct ColumnBounds {
  std::vector<double> Trajectory::*values;
  std::string_view column, unit;
  double low, high, shown;  // shown: factor to what the file has
  std::array<OtherUnit, 2> others;
};
constexpr double kTwoTurns = 4 * kPi;
// Loads end at 100 %; some servos report a count more.
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
                 {{{2 * kPi / 60, "are these rpm? name the column speed_rpm then"},
                   {kPi / 180, "are these degrees? name the column speed_deg_s then"}}}},
    ColumnBounds{&Trajectory::load, "load", "%", -1.01, 1.01, 100, {{{100.0 / 2047, messages::kRawCounts}, {0, ""}}}},
    ColumnBounds{&Trajectory::volt_v, "volt", "V", 3, 30, 1, {{{0.1, messages::kRawCounts}, {0, ""}}}},
    ColumnBounds{&Trajectory::temp_c, "temp", "degC", -20, 100, 1, {{{0, ""}, {0, ""}}}},
};

std::string sixDigits(double value) {
  char text[32];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.6g", value))};
}

std::vector<std::size_t> knownRows(const std::vector<double>& values) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < values.size(); ++row)
    if (!std::isnan(values[row])) rows.push_back(row);
  return rows;
}

bool areFew(std::size_t some, std::size_t all) {
  return static_cast<double>(some) <= kMostMasked * static_cast<double>(all);
}

/// Rows without a reading are left out: nothing is masked there.
void mask(Trajectory& log, const ColumnBounds& of, std::vector<std::size_t> rows, std::string_view why) {
  std::erase_if(rows, [&](std::size_t row) { return std::isnan((log.*of.values)[row]); });
  if (rows.empty()) return;
  for (const std::size_t row : rows) (log.*of.values)[row] = kMasked;
  log.masked.push_back({.column = of.column, .why = why, .rows = rows.size(), .first_line = log.lines[rows.front()]});
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
  MaskedReadings empty{.column = kColumnBounds[0].column, .why = messages::kMaskedMissing};
  for (std::size_t row = 0; row < log.rows(); ++row)
    if (std::isnan(log.position_rad[row]) && ++empty.rows == 1) empty.first_line = log.lines[row];
  if (!areFew(empty.rows, log.rows()))
    throw BadInput(file + ", line " + std::to_string(empty.first_line) + ": pos is empty, as in " +
                   std::to_string(empty.rows) + " of " + std::to_string(log.rows()) +
                   " rows; leave rows out that were not measured");
  if (empty.rows > 0) log.masked.push_back(empty);
}

/// Sets of rows that are too many for lone faults stay: the bounds or the units are wrong, which other checks find.
void maskIfFew(Trajectory& log, const ColumnBounds& of, const std::vector<std::size_t>& rows, std::string_view why) {
  if (areFew(rows.size(), log.rows())) mask(log, of, rows, why);
}

/// Rows that no chain of positions at the greatest speed passes. Rows may be read up to a period late.
void maskPositionsOffTheChain(Trajectory& log, const PhysicalLimits& limits, double period_s) {
  const auto can = [&](std::size_t i, std::size_t j) {
    const double time_s = log.time_s[j] - log.time_s[i] + period_s;
    return std::abs(log.position_rad[j] - log.position_rad[i]) <=
           limits.speed_rad_s * time_s + kReadingSteps * limits.encoder_step_rad;
  };
  maskIfFew(log, kColumnBounds[0], outsideLongestChain(knownRows(log.position_rad), can), messages::kMaskedJump);
}

/// Distance of the reading `at` beyond those before and after it, less what the greatest acceleration reaches in a turn
/// between the two.
double beyondNeighbours(const Trajectory& log, std::size_t before, std::size_t at, std::size_t after,
                        const PhysicalLimits& limits) {
  const auto [low, high] = std::minmax(log.position_rad[before], log.position_rad[after]);
  const double time_s = log.time_s[after] - log.time_s[before];
  const double turn = limits.accel_rad_s2 * time_s * time_s / 8 + kReadingSteps * limits.encoder_step_rad;
  return std::max(low - log.position_rad[at], log.position_rad[at] - high) - turn;
}

/// The neighbours of a false reading look false too, but less.
void maskLonePositions(Trajectory& log, const PhysicalLimits& limits) {
  const std::vector<std::size_t> rows = knownRows(log.position_rad);
  if (rows.size() < 3) return;
  std::vector<double> beyond(rows.size(), 0);
  for (std::size_t i = 1; i + 1 < rows.size(); ++i)
    beyond[i] = beyondNeighbours(log, rows[i - 1], rows[i], rows[i + 1], limits);
  std::vector<std::size_t> lone;
  for (std::size_t i = 1; i + 1 < rows.size(); ++i)
    if (beyond[i] > 0 && beyond[i] > beyond[i - 1] && beyond[i] >= beyond[i + 1]) lone.push_back(rows[i]);
  maskIfFew(log, kColumnBounds[0], lone, messages::kMaskedJump);
}

/// Same registers as in the row before; one of speed and load is read, and not 0.
bool repeatsRowBefore(const Trajectory& log, std::size_t row) {
  bool informative = false;
  for (const ColumnBounds& of : kColumnBounds) {
    const double now = (log.*of.values)[row], before = (log.*of.values)[row - 1];
    if (std::isnan(now) != std::isnan(before) || now < before || now > before) return false;
    informative =
        informative || ((of.values == &Trajectory::speed_rad_s || of.values == &Trajectory::load) && std::abs(now) > 0);
  }
  return informative && !std::isnan(log.position_rad[row]);
}

/// Old answers read again: the joint moved before at some speed, and then is where that speed brings it.
void maskStaleRows(Trajectory& log, const PhysicalLimits& limits) {
  constexpr double kLongest = 0.1;    // s
  constexpr double kSameSpeed = 0.5;  // of the distance that was expected
  constexpr double kMovedSteps = 8;   // of the encoder, in one row: far above its noise
  std::vector<std::size_t> stale;
  for (std::size_t from = 2; from + 1 < log.rows(); ++from) {
    if (!repeatsRowBefore(log, from)) continue;
    std::size_t to = from;
    while (to + 2 < log.rows() && repeatsRowBefore(log, to + 1)) ++to;
    const double speed =
        (log.position_rad[from - 1] - log.position_rad[from - 2]) / (log.time_s[from - 1] - log.time_s[from - 2]);
    const double expected = speed * (log.time_s[to + 1] - log.time_s[from - 1]);
    const double moved = log.position_rad[to + 1] - log.position_rad[from - 1];
    const bool fast =
        std::abs(speed) * (log.time_s[from] - log.time_s[from - 1]) >= kMovedSteps * limits.encoder_step_rad;
    if (fast && log.time_s[to] - log.time_s[from - 1] <= kLongest &&
        std::abs(moved - expected) <= kSameSpeed * std::abs(expected))
      for (std::size_t row = from; row <= to; ++row) stale.push_back(row);
    from = to;
  }
  if (!areFew(stale.size(), log.rows())) return;
  for (const ColumnBounds& of : kColumnBounds) mask(log, of, stale, messages::kMaskedStale);
}

void maskTemperatures(Trajectory& log, const PhysicalLimits& limits) {
  constexpr double kRegisterSteps = 2;  // degC: two readings, each at the edge of a step
  const auto can = [&](std::size_t i, std::size_t j) {
    return std::abs(log.temp_c[j] - log.temp_c[i]) <=
           kRegisterSteps + limits.heating_k_s * (log.time_s[j] - log.time_s[i]);
  };
  maskIfFew(log, kColumnBounds[4], outsideLongestChain(knownRows(log.temp_c), can), messages::kMaskedHeat);
}

void maskVoltages(Trajectory& log, const PhysicalLimits& limits) {
  std::vector<std::size_t> outside;
  for (std::size_t row = 0; row < log.rows(); ++row)
    if (log.volt_v[row] < limits.low_v || log.volt_v[row] > limits.high_v) outside.push_back(row);
  maskIfFew(log, kColumnBounds[3], outside, messages::kMaskedSupply);
}

void maskSpeeds(Trajectory& log, const PhysicalLimits& limits) {
  std::vector<std::size_t> outside;
  for (std::size_t row = 0; row < log.rows(); ++row)
    if (std::abs(log.speed_rad_s[row]) > limits.speed_rad_s) outside.push_back(row);
  maskIfFew(log, kColumnBounds[1], outside, messages::kMaskedJump);
}

double medianOf(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return kMasked;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Each check may mask few, and all of them together too many. Positions must be there; other columns may be sparse.
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

}  // namespace

void maskBadRows(Trajectory& log, const std::string& file, const Case& c) {
  noteEmptyPositions(log, file);
  for (const ColumnBounds& of : kColumnBounds) maskOutOfRange(log, file, of);
  const PhysicalLimits limits = limitsOf(c, log, medianOf(log.volt_v));
  maskStaleRows(log, limits);
  maskPositionsOffTheChain(log, limits, periodOf(log));
  maskLonePositions(log, limits);
  maskSpeeds(log, limits);
  maskVoltages(log, limits);
  maskTemperatures(log, limits);
  refuseManyMasked(log, file);
}

std::string asSentence(const Trajectory& log, const MaskedReadings& masked) {
  return log.file + ": " + std::to_string(masked.rows) + " of " + std::to_string(log.rows()) + " readings of " +
         std::string{masked.column} + " masked, the first in line " + std::to_string(masked.first_line) + ": " +
         std::string{masked.why};
}

}  // namespace darwinop::gap
