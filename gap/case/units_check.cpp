// Detects degrees in place of radians: too fast, on the wrong grid, inconsistent with the other columns.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>

#include "core/units.hpp"
#include "gap/case/messages.hpp"
#include "gap/case/plausible.hpp"
#include "gap/case/position_step.hpp"

namespace darwinop::gap {
namespace {

constexpr double kWindow = 0.02;                   // s; speeds over less are made of the encoder's steps
constexpr double kTooFast = 4;                     // times the speed without load
constexpr double kFallShare = 1.5;                 // of the speed of a free fall from the top
constexpr double kUnitGridShare = 0.99;            // of the rows
constexpr std::size_t kUnitGridValues = 10;        // different positions that it takes to see a grid
constexpr double kSameStep = 0.02;                 // of a step; a column of turns has 1 / ticks_per_rev
constexpr double kMoved = 0.02;                    // rad, rms of a motion that can be compared
constexpr double kSlopeLow = 40, kSlopeHigh = 80;  // about 180 / pi
constexpr double kSpeedRatio = 4;                  // of register and differenced speed: rpm gives 9.5, degrees 57

std::string three(double value) {
  char text[32];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.3g", value))};
}

/// The row from which the motion into `row` is measured; `row` itself at the beginning.
std::size_t before(const Trajectory& log, std::size_t row, std::size_t from) {
  while (from + 1 < row && log.time_s[row] - log.time_s[from + 1] >= kWindow) ++from;
  return log.time_s[row] - log.time_s[from] >= kWindow ? from : row;
}

void checkSpeed(const Trajectory& log, const std::string& file, const Case& c) {
  const twin::Pendulum arm = armOf(c, log);
  const double fall = 2 * std::sqrt(arm.gravity_m_s2 / arm.length_m);
  const double most = std::max(kTooFast * noLoadSpeed(c, log), kFallShare * fall);
  std::size_t from = 0;
  double reported = 0, moved = 0;
  for (std::size_t row = 1; row < log.rows(); ++row) {
    from = before(log, row, from);
    if (from == row) {
      from = 0;
      continue;
    }
    const double speed = (log.position_rad[row] - log.position_rad[from]) / (log.time_s[row] - log.time_s[from]);
    if (std::abs(speed) > most)
      throw BadInput(file + ", line " + std::to_string(log.lines[row]) + ": pos moves at " + three(std::abs(speed)) +
                     messages::kTooFastForServo + three(noLoadSpeed(c, log)) +
                     "; if these are degrees, name the column pos_deg. Many jumps are wrong readings: "
                     "check the cable and measure again");
    if (std::isnan(log.speed_rad_s[row]) || std::isnan(speed)) continue;
    reported += log.speed_rad_s[row] * log.speed_rad_s[row];
    moved += speed * speed;
  }
  const double rows = double(log.rows());
  const double ratio = std::sqrt(reported / moved);
  if (std::sqrt(moved / rows) > 10 * kMoved && (ratio > kSpeedRatio || (reported > 0 && ratio < 1 / kSpeedRatio)))
    throw BadInput(file + ": speed is " + three(ratio) +
                   " times as fast as pos moves; its unit is another, so name "
                   "the column speed_rpm or speed_deg_s, or leave it out");
}

/// A column on the grid of the encoder in another unit is in that unit. One on a grid of its own is a share of a range,
/// as programs for grippers log it, or another encoder's.
void checkGrid(const Trajectory& log, const std::string& file, Case& c) {
  std::vector<double> known = log.position_rad;
  std::erase_if(known, [](double position) { return std::isnan(position); });
  const std::set<double> values{known.begin(), known.end()};
  if (values.size() < kUnitGridValues) return;
  const double turn = 1.0 / c.model.servo.ticks_per_rev, tick = 2 * kPi * turn;
  if (shareOnGrid(known, tick) >= kUnitGridShare) return;
  if (shareOnGrid(known, 360 * turn) >= kUnitGridShare)
    throw BadInput(file + ": pos goes in steps of " + three(360 * turn) +
                   ", which are the encoder's in degrees; name the column pos_deg, and goal_deg likewise");
  const std::optional<double> step = commonStep(known);
  if (step && std::abs(*step / turn - 1) < kSameStep)
    throw BadInput(file + ": pos goes in steps of " + three(*step) + messages::kStepsOfTurns);
  if (!c.quantised) return;
  const std::string steps_of = file + ": pos does not go in steps of the encoder (" + three(tick) + " rad)";
  c.warnings.push_back(step ? steps_of + " but of " + three(*step) + messages::kOtherSteps
                            : steps_of + "; filtered or resampled logs hide what happened");
}

/// Positions against the goals that they follow.
void checkGoals(const Trajectory& log, const std::string& file) {
  double n = 0, g = 0, p = 0, gg = 0, pp = 0, gp = 0;
  for (std::size_t i = 0; i < log.rows(); ++i) {
    if (log.torque_on[i] == 0 || std::isnan(log.position_rad[i])) continue;
    const double goal = log.goal_rad[i], position = log.position_rad[i];
    n += 1, g += goal, p += position, gg += goal * goal, pp += position * position, gp += goal * position;
  }
  if (n < 2) return;
  const double goals = gg - g * g / n, positions = pp - p * p / n, both = gp - g * p / n;
  if (std::sqrt(std::min(goals, positions) / n) < kMoved / 4 || both * both < 0.8 * goals * positions) return;
  const double slope = std::sqrt(positions / goals);
  const auto is_degrees = [](double ratio) { return ratio > kSlopeLow && ratio < kSlopeHigh; };
  if (is_degrees(slope))
    throw BadInput(file + ": pos moves " + three(slope) + " times as far as goal" + messages::kOneInDegrees +
                   "pos_deg");
  if (is_degrees(1 / slope))
    throw BadInput(file + ": goal moves " + three(1 / slope) + " times as far as pos" + messages::kOneInDegrees +
                   "goal_deg");
}

}  // namespace

void checkUnits(const Trajectory& log, const std::string& file, Case& c) {
  checkGoals(log, file);
  checkSpeed(log, file, c);
  checkGrid(log, file, c);
}

}  // namespace darwinop::gap
