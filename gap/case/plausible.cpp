// Values out of their physical range, and time that does not go on evenly.
#include "gap/case/plausible.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/units.hpp"
#include "experiments/logs/read_log.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

struct Range {
  std::vector<double> Trajectory::*values;
  std::string_view column, unit;
  double low, high, shown;  // shown: factor to what the file has
  std::string_view advice;
};
constexpr double kTurns = 4 * kPi;
// Loads end at 100 %; some servos report a count more.
const std::array kRanges{
    Range{&Trajectory::goal_rad, "goal", "rad", -kTurns, kTurns, 1, "are these degrees? name the column goal_deg then"},
    Range{&Trajectory::position_rad, "pos", "rad", -kTurns, kTurns, 1,
          "are these degrees? name the column pos_deg then"},
    Range{&Trajectory::speed_rad_s, "speed", "rad/s", -100, 100, 1,
          "are these rpm or degrees? name the column speed_rpm or speed_deg_s then"},
    Range{&Trajectory::load, "load", "%", -1.01, 1.01, 100,
          "it is the share of the greatest duty; are these raw counts?"},
    Range{&Trajectory::volt_v, "volt", "V", 3, 30, 1, "are these raw counts of 0.1 V?"},
    Range{&Trajectory::temp_c, "temp", "degC", -20, 100, 1, "is this degree Celsius?"},
};

constexpr double kShortest = 2;         // s
constexpr double kLongestPeriod = 0.1;  // s
constexpr double kLongestHole = 20;     // periods

std::string number(double value) {
  char text[32];
  return {text, static_cast<std::size_t>(std::snprintf(text, sizeof text, "%.6g", value))};
}

std::string at(const std::string& file, const Trajectory& log, std::size_t row) {
  return file + ", line " + std::to_string(log.lines[row]) + ": ";
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
    if (step > kLongestHole * period)
      throw BadInput(at(file, log, i) + "the log has a hole of " + number(step) + " s before this row; split it there");
  }
}

}  // namespace

void checkRows(const Trajectory& log, const std::string& file) {
  if (log.rows() < 2) throw BadInput(file + ": no rows; was anything measured?");
  for (const Range& range : kRanges) {
    const std::vector<double>& values = log.*range.values;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] < range.low || values[i] > range.high)
        throw BadInput(at(file, log, i) + std::string{range.column} + " is " + number(values[i] * range.shown) + " " +
                       std::string{range.unit} + messages::kOutsideServoRange + number(range.low * range.shown) +
                       " to " + number(range.high * range.shown) + "); " + std::string{range.advice});
  }
  checkTime(log, file);
}

double periodOf(const Trajectory& log) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < log.rows(); ++i) steps.push_back(log.time_s[i] - log.time_s[i - 1]);
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

double noLoadSpeed(const Case& c) {
  const twin::ServoParameters& servo = c.model.servo;
  if (servo.law == twin::Law::kSpeedP) return servo.speed_max_rad_s;
  return servo.duty_max * servo.supply_v / servo.back_emf_vs_rad;
}

}  // namespace darwinop::gap
