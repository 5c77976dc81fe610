// Goals out of their physical range, and time that does not go on evenly.
#include "gap/case/plausible.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/units.hpp"
#include "experiments/logs/read_log.hpp"
#include "gap/case/median.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

constexpr double kShortest = 2;         // s
constexpr double kLongestPeriod = 0.1;  // s
// A pause of the host: the last goal stands, in the servo as in the simulation. Longer ones are two logs in one file.
constexpr double kLongestHole = 20;    // periods
constexpr double kLongestPause = 0.5;  // s, where that is more

std::string number(double value) {
  char text[32];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.6g", value))};
}

std::string at(const std::string& file, const Trajectory& log, std::size_t row) {
  return file + ", line " + std::to_string(log.lines[row]) + ": ";
}

/// A goal is a command, not a reading: a wrong one moved the joint, or is not what was sent.
void refuseWildGoals(const Trajectory& log, const std::string& file) {
  constexpr double kTurns = 4 * kPi;
  const auto beyond = [](double goal) { return std::abs(goal) > kTurns; };
  const auto first = std::ranges::find_if(log.goal_rad, beyond);
  if (first == log.goal_rad.end()) return;
  const bool degrees =
      std::ranges::all_of(log.goal_rad, [](double goal) { return std::abs(goal) <= kTurns * 180 / kPi; });
  const auto row = static_cast<std::size_t>(first - log.goal_rad.begin());
  throw BadInput(at(file, log, row) + "goal is " + number(*first) + " rad" + messages::kOutsideServoRange +
                 number(-kTurns) + " to " + number(kTurns) + "); " +
                 (degrees ? "are these degrees? name the column goal_deg then" : "correct the log"));
}

void checkTime(const Trajectory& log, const std::string& file) {
  if (log.duration_s() < kShortest)
    throw BadInput(file + ": " + number(log.duration_s()) + " s of data; a log needs " + number(kShortest) +
                   " s or more");
  const double period = periodOf(log);
  if (period > kLongestPeriod)
    throw BadInput(file + ": a row every " + number(period) + " s; the motion of a joint needs one every " +
                   number(kLongestPeriod) + " s or more often");
  for (std::size_t i = 1; i < log.rows(); ++i) {
    const double step = log.time_s[i] - log.time_s[i - 1];
    if (step <= 0) throw BadInput(at(file, log, i) + logs::kTimeGoesBack + "; if the file contains two logs, split it");
    if (step > std::max(kLongestHole * period, kLongestPause))
      throw BadInput(at(file, log, i) + "the log has a hole of " + number(step) + " s before this row; split it there");
  }
}

double noLoadSpeedAt(const Case& c, double supply_v) {
  const twin::ServoParameters& servo = c.model.servo;
  if (servo.law == twin::Law::kSpeedP) return servo.speed_max_rad_s;
  return servo.duty_max * supply_v / servo.back_emf_vs_rad;
}

}  // namespace

void checkRows(const Trajectory& log, const std::string& file) {
  if (log.rows() < 2) throw BadInput(file + ": no rows; was anything measured?");
  refuseWildGoals(log, file);
  checkTime(log, file);
}

double periodOf(const Trajectory& log) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < log.rows(); ++i) steps.push_back(log.time_s[i] - log.time_s[i - 1]);
  return steps.empty() ? 0 : medianOf(std::move(steps));
}

double noLoadSpeed(const Case& c) {
  return noLoadSpeedAt(c, c.model.servo.supply_v);
}

double noLoadSpeed(const Case& c, const Trajectory& log) {
  return noLoadSpeedAt(c, supplyOf(c, log));
}

}  // namespace darwinop::gap
