// Masks readings that contradict their neighbours, by physical bounds: no reading is judged by how rare it is.
#include "gap/case/bad_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "gap/case/chain.hpp"
#include "gap/case/column_bounds.hpp"
#include "gap/case/limits.hpp"
#include "gap/case/median.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/plausible.hpp"

namespace darwinop::gap {
namespace {

constexpr double kReadingSteps = 4;  // of the encoder: rounding and noise of two readings

std::vector<std::size_t> knownRows(const std::vector<double>& values) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < values.size(); ++row)
    if (!std::isnan(values[row])) rows.push_back(row);
  return rows;
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
  maskIfFew(log, columnBounds()[kPos], outsideLongestChain(knownRows(log.position_rad), can), messages::kMaskedJump);
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
  maskIfFew(log, columnBounds()[kPos], lone, messages::kMaskedJump);
}

/// Same registers as in the row before; one of speed and load is read, and not 0.
bool repeatsRowBefore(const Trajectory& log, std::size_t row) {
  bool informative = false;
  for (const ColumnBounds& of : columnBounds()) {
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
  for (const ColumnBounds& of : columnBounds()) mask(log, of, stale, messages::kMaskedStale);
}

void maskTemperatures(Trajectory& log, const PhysicalLimits& limits) {
  constexpr double kRegisterSteps = 2;  // degC: two readings, each at the edge of a step
  const auto can = [&](std::size_t i, std::size_t j) {
    return std::abs(log.temp_c[j] - log.temp_c[i]) <=
           kRegisterSteps + limits.heating_k_s * (log.time_s[j] - log.time_s[i]);
  };
  maskIfFew(log, columnBounds()[kTemp], outsideLongestChain(knownRows(log.temp_c), can), messages::kMaskedHeat);
}

void maskVoltages(Trajectory& log, const PhysicalLimits& limits) {
  std::vector<std::size_t> outside;
  for (std::size_t row = 0; row < log.rows(); ++row)
    if (log.volt_v[row] < limits.low_v || log.volt_v[row] > limits.high_v) outside.push_back(row);
  maskIfFew(log, columnBounds()[kVolt], outside, messages::kMaskedSupply);
}

/// True: with other goals, or torque on or off, around this row, a duty may have jumped there and come back.
bool mayJumpAt(const Trajectory& log, std::size_t row, double duty_per_rad, double jump) {
  const std::size_t from = row < 2 ? 0 : row - 2;
  double low = log.goal_rad[from], high = low;
  for (std::size_t i = from; i <= row + 1; ++i) {
    if (log.torque_on[i] != log.torque_on[from]) return true;
    low = std::min(low, log.goal_rad[i]), high = std::max(high, log.goal_rad[i]);
  }
  return !(duty_per_rad * (high - low) <= jump / 2);  // of an unknown gain as well
}

/// The duty of a position controller follows its error, which no arm throws to and fro within two rows.
void maskLoneLoads(Trajectory& log, const twin::ServoParameters& servo) {
  constexpr double kJump = 0.5, kBack = 0.1;  // of the full duty
  if (servo.law != twin::Law::kVoltageP) return;
  std::vector<std::size_t> lone;
  for (std::size_t row = 1; row + 1 < log.rows(); ++row) {
    const double before = log.load[row - 1], after = log.load[row + 1];
    const bool jumps =
        std::abs(after - before) <= kBack && std::abs(log.load[row] - std::midpoint(before, after)) >= kJump;
    const double duty_per_rad = servo.duty_per_kp_per_rad * log.pRegisterAt(row);
    if (jumps && !mayJumpAt(log, row, duty_per_rad, kJump)) lone.push_back(row);
  }
  maskIfFew(log, columnBounds()[kLoad], lone, messages::kMaskedLoad);
}

void maskSpeeds(Trajectory& log, const PhysicalLimits& limits) {
  std::vector<std::size_t> outside;
  for (std::size_t row = 0; row < log.rows(); ++row)
    if (std::abs(log.speed_rad_s[row]) > limits.speed_rad_s) outside.push_back(row);
  maskIfFew(log, columnBounds()[kSpeed], outside, messages::kMaskedJump);
}

}  // namespace

void maskBadRows(Trajectory& log, const std::string& file, const Case& c) {
  noteEmptyPositions(log, file);
  for (const ColumnBounds& of : columnBounds()) maskOutOfRange(log, file, of);
  const PhysicalLimits limits = limitsOf(c, log, medianOf(log.volt_v));
  maskStaleRows(log, limits);
  maskPositionsOffTheChain(log, limits, periodOf(log));
  maskLonePositions(log, limits);
  maskSpeeds(log, limits);
  maskLoneLoads(log, c.model.servo);
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
