#include "gap/case/body/body_check.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/servo_limits.hpp"
#include "core/text/nearest.hpp"
#include "gap/case/body/clamped_trunk.hpp"
#include "gap/case/median.hpp"

namespace darwinop::gap {
namespace {

constexpr double kUnmoved = 4 * kRadPerTick;  // rad: noise of an encoder is a tick
constexpr double kIndependent = 0.3;          // sine of the least angle between directions of gravity

double dot(const Axes& a, const Axes& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

bool isEmpty(const std::vector<double>& column) {
  return std::ranges::all_of(column, [](double value) { return std::isnan(value); });
}

/// "gyro.x"
std::vector<std::string> emptyAxes(const std::string& sensor, const AxesColumns& columns) {
  std::vector<std::string> out;
  for (std::size_t axis = 0; axis < columns.size(); ++axis)
    if (isEmpty(columns[axis])) out.push_back(sensor + "." + "xyz"[axis]);
  return out;
}

BodyLogCheck checkOf(const BodyCase& given, std::size_t i) {
  const BodyLog& log = given.logs[i];
  BodyLogCheck out;
  std::vector<double> steps;
  for (std::size_t row = 1; row < log.rows(); ++row) steps.push_back(log.time_s[row] - log.time_s[row - 1]);
  out.duration_s = log.time_s.back();
  out.period_s = medianOf(steps);
  out.late_rows =
      static_cast<std::size_t>(std::ranges::count_if(steps, [&](double step) { return step > 1.5 * out.period_s; }));
  for (std::size_t j = 0; j < kJoints; ++j) {
    if (given.is_absent[j]) continue;
    const Trajectory& joint = given.joint(i, j);
    const auto limp = std::ranges::count(joint.torque_on, 0);
    if (limp > 0) out.limp.push_back(kJointTable[j].name);
    out.limp_s = std::max(out.limp_s, static_cast<double>(limp) * out.period_s);
    double low = 1e9, high = -1e9;
    for (const double position : joint.position_rad) {
      if (std::isnan(position)) ++out.unanswered;
      low = std::fmin(low, position), high = std::fmax(high, position);
    }
    if (high - low < kUnmoved) out.unmoved.push_back(kJointTable[j].name);
  }
  out.no_reading = emptyAxes("gyro", log.gyro_rad_s);
  for (std::string& column : emptyAxes("accelerometer", log.accel_m_s2)) out.no_reading.push_back(std::move(column));
  out.greatest_rate_rad_s = greatestRate(log.gyro_rad_s);
  return out;
}

/// Gravity's directions that the accelerometer has read in clamped logs: how many are linearly independent (Gram and
/// Schmidt).
std::size_t orientationsOf(const BodyCase& given) {
  std::vector<Axes> basis;
  for (const BodyLog& log : given.logs) {
    if (!log.up || log.held_out || std::ranges::all_of(log.accel_m_s2, isEmpty)) continue;
    Axes left = *log.up;
    for (const Axes& one : basis) {
      const double along = dot(left, one);
      for (std::size_t axis = 0; axis < 3; ++axis) left[axis] -= along * one[axis];
    }
    const double length = std::sqrt(dot(left, left));
    if (length < kIndependent) continue;
    for (double& value : left) value /= length;
    basis.push_back(left);
  }
  return basis.size();
}

}  // namespace

std::string noReadingText(const BodyLogCheck& check) {
  if (check.no_reading.empty()) return "";
  const std::vector<std::string_view> columns{check.no_reading.begin(), check.no_reading.end()};
  return text::listed(columns) + ": no reading; run `darwinop doctor`, and record it again";
}

BodyCheck checkData(const BodyCase& given) {
  BodyCheck out;
  out.warnings = given.warnings;
  for (std::size_t i = 0; i < given.logs.size(); ++i) out.logs.push_back(checkOf(given, i));
  out.orientations = orientationsOf(given);
  if (std::ranges::none_of(given.logs, [](const BodyLog& log) { return log.up && !log.held_out; }))
    out.cannot_show.emplace_back("bias, scale, axes and mounting of the inertial sensor: clamp the trunk in a stand");
  else if (out.orientations < 3)
    out.cannot_show.push_back("bias, scale, axes and mounting of the accelerometer apart: gravity is read along " +
                              std::to_string(out.orientations) + " of 3 axes; clamp the trunk on a side and face down");
  for (std::size_t i = 0; i < given.logs.size(); ++i)
    if (const std::string text = noReadingText(out.logs[i]); !text.empty())
      out.cannot_show.push_back(given.logs[i].file + ": " + text);
  if (!given.isComplete()) out.cannot_show.push_back(absentText(given));
  const auto has = [&](const auto& is) { return std::ranges::any_of(out.logs, is); };
  if (!has([](const BodyLogCheck& log) { return !log.limp.empty(); }))
    out.cannot_show.emplace_back("friction apart from the motor: record a joint that falls limp");
  if (std::ranges::none_of(given.logs, [](const BodyLog& log) { return log.repeat_of.has_value(); }))
    out.cannot_show.emplace_back("the noise between runs: record a log twice");
  if (std::ranges::none_of(given.logs, &BodyLog::held_out))
    out.cannot_show.emplace_back("whether a found effect predicts: keep a recording with \"role\": \"held_out\"");
  return out;
}

}  // namespace darwinop::gap
