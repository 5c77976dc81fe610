// Plots specific to the experiments of 2013, one table row each; see the table in docs/plots.md.
#include "experiments/logs/plot/experiment_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text/number_text.hpp"
#include "core/units.hpp"
#include "experiments/logs/plot/messages.hpp"
#include "experiments/logs/plot/steps.hpp"
#include "experiments/logs/plot/text.hpp"
#include "experiments/logs/plot/traces.hpp"

namespace darwinop::plot {
namespace {

using Part = const logs::Column* JointColumns::*;

/// The first joint named in the header, or the joint with the largest range of this column, or of the position.
std::optional<JointColumns> joint(const logs::Log& log, Part part) {
  const std::vector<JointColumns> joints = jointsOf(log);
  const std::string named = log.headValue("joints").value_or("");
  const std::string first = named.substr(0, named.find(' '));
  const auto by_name = std::find_if(joints.begin(), joints.end(), [&](const auto& j) { return j.name == first; });
  if (by_name != joints.end()) return *by_name;
  for (const Part by : {part, &JointColumns::position}) {
    const auto most = std::max_element(joints.begin(), joints.end(),
                                       [&](const auto& a, const auto& b) { return range(a.*by) < range(b.*by); });
    if (most != joints.end() && range((*most).*by) > 0) return *most;
  }
  return std::nullopt;
}

std::string angleOf(const JointColumns& j) {
  return withUnit("angle of " + j.name, j.position->unit);
}

/// A range of rows of two columns.
Curve part(const RowRange& rows, const std::vector<double>& x, const std::vector<double>& y) {
  const auto begin = static_cast<std::ptrdiff_t>(rows.begin), end = static_cast<std::ptrdiff_t>(rows.end);
  Curve curve;
  curve.x.assign(x.begin() + begin, x.begin() + end);
  curve.y.assign(y.begin() + begin, y.begin() + end);
  return curve;
}

/// Several row ranges as one curve with gaps.
Curve parts(const std::vector<RowRange>& all, const std::vector<double>& x, const std::vector<double>& y) {
  Curve curve;
  for (const RowRange& rows : all) {
    const Curve one = part(rows, x, y);
    curve.x.insert(curve.x.end(), one.x.begin(), one.x.end());
    curve.y.insert(curve.y.end(), one.y.begin(), one.y.end());
    curve.x.push_back(one.x.back());
    curve.y.push_back(NAN);
  }
  return curve;
}

/// The three axes of a device over x.
std::vector<LogCurve> axes(const logs::Log& log, const std::vector<RowRange>& rows, const std::vector<double>& x,
                           const std::string& device, const std::string& what) {
  std::vector<LogCurve> pieces;
  if (rows.empty()) return pieces;
  for (const char* axis : {"x", "y", "z"})
    if (const logs::Column* column = log.find(device + "." + axis); column != nullptr)
      pieces.push_back({device, column->name, axis, withUnit(what, column->unit), parts(rows, x, column->values)});
  return pieces;
}

/// From the start to the end of the experiment.
std::vector<LogCurve> axesOverTime(const logs::Log& log, const std::string& device, const std::string& what) {
  const std::size_t start = startRow(log);
  return axes(log, {{start, endRow(log)}}, timeFrom(log, start), device, what);
}

std::vector<LogCurve> gyroscope(const logs::Log& log) {
  return axesOverTime(log, "gyro", "rate");
}

std::vector<LogCurve> accelerometer(const logs::Log& log) {
  return axesOverTime(log, "accelerometer", "acceleration");
}

/// First row in which the acceleration differs from one g: the robot falls. Later rows are omitted, because impacts
/// would enlarge the scale a hundredfold.
std::size_t firstFall(const logs::Log& log, const RowRange& rows) {
  const logs::Column *x = log.find("accelerometer.x"), *y = log.find("accelerometer.y"),
                     *z = log.find("accelerometer.z");
  if (x == nullptr || y == nullptr || z == nullptr) return rows.end;
  constexpr double kFalls = 0.3 * kGravity;
  std::size_t row = rows.begin;
  while (row < rows.end && !(std::abs(std::hypot(x->values[row], y->values[row], z->values[row]) - kGravity) > kFalls))
    ++row;
  return std::max(row, rows.begin + 1);
}

std::vector<LogCurve> bow(const logs::Log& log) {
  const auto ankle = joint(log, &JointColumns::requested);
  if (!ankle) return {};
  std::vector<RowRange> rows = slowRanges(log, *ankle);
  for (RowRange& range : rows) range.end = firstFall(log, range);
  return axes(log, rows, ankle->position->values, "accelerometer", "acceleration");
}

std::vector<LogCurve> speed(const logs::Log& log) {
  const auto j = joint(log, &JointColumns::speed);
  if (!j || j->speed == nullptr) return {};
  std::vector<std::pair<double, double>> sweeps;
  for (const GoalStep& step : largeSteps(*j, startRow(log)))
    if (const double time = arrival(log, *j, step); !std::isnan(time))
      sweeps.emplace_back(j->speed->values[step.begin], time);
  std::sort(sweeps.begin(), sweeps.end());
  Curve curve;
  curve.style = Style::kMarks;
  for (const auto& [setting, time] : sweeps) {
    curve.x.push_back(setting);
    curve.y.push_back(time);
  }
  if (sweeps.empty()) return {};
  return {{"sweep of " + j->name, "sweep of " + j->name, "sweeps", "time per sweep [s]", curve}};
}

std::vector<LogCurve> damping(const logs::Log& log) {
  const auto j = joint(log, &JointColumns::torque_on);
  if (!j) return {};
  const std::vector<RowRange> releases = limpRanges(*j, startRow(log));
  std::vector<LogCurve> pieces;
  for (const RowRange& rows : releases) {
    const std::string name = releases.size() == 1 ? "measured" : "release " + std::to_string(pieces.size() + 1);
    pieces.push_back({j->name, releases.size() == 1 ? j->name : name, name, angleOf(*j),
                      part(rows, timeFrom(log, rows.begin), j->position->values)});
  }
  return pieces;
}

std::vector<LogCurve> gain(const logs::Log& log) {
  const auto j = joint(log, &JointColumns::p_gain);
  if (!j || j->p_gain == nullptr) return {};
  std::vector<LogCurve> pieces;
  for (const GoalStep& step : largeSteps(*j, startRow(log))) {
    if (step.to < step.from) continue;  // the return motion
    std::string label = "P = ";
    label += text::generalText(j->p_gain->values[step.begin], 4);
    pieces.push_back({j->name, label, label, angleOf(*j),
                      part({step.begin, step.end}, timeFrom(log, step.begin), j->position->values)});
  }
  return pieces;
}

std::vector<LogCurve> torqueFeedback(const logs::Log& log) {
  const auto j = joint(log, &JointColumns::load);
  if (!j || j->load == nullptr) return {};
  std::vector<LogCurve> pieces;
  for (const RowRange& rows : slowRanges(log, *j)) {
    const bool up = j->requested->values[rows.end - 1] > j->requested->values[rows.begin];
    const std::string direction = up ? messages::kAngleRising : messages::kAngleFalling;
    pieces.push_back({j->name, direction, direction, withUnit("load of " + j->name, "1 = maximum torque"),
                      part(rows, j->position->values, j->load->values)});
  }
  return pieces;
}

std::vector<LogCurve> angleOverTorque(const logs::Log& log) {
  const auto j = joint(log, &JointColumns::torque);
  if (!j) return {};
  const RowRange rows = torqueSlope(*j);
  if (rows.begin == rows.end) return {};
  return {{j->name, j->name, "measured", angleOf(*j), part(rows, j->torque->values, j->position->values)}};
}

constexpr auto kPlots = std::to_array<ExperimentPlot>({
    {"speed", messages::kSweepTimes, messages::kSpeedSetting, speed},
    {"damping", "released arm", messages::kTimeSinceRelease, damping},
    {"release", "released arm", messages::kTimeSinceRelease, damping},
    {"gain", "step responses", "time since the step [s]", gain},
    {"torque-feedback", "load over angle", "angle [rad]", torqueFeedback},
    {"max-torque", "angle over torque limit", "torque limit [N m]", angleOverTorque},
    {"applied-torque", "angle over applied torque", "applied torque [N m]", angleOverTorque},
    {"gyroscope", "gyroscope", "time [s]", gyroscope},
    {"accelerometer", "accelerometer", "time [s]", accelerometer},
    {"bow", "accelerometer over ankle angle", messages::kAnkleAngle, bow},
});

}  // namespace

const ExperimentPlot* experimentPlot(const logs::Log& log) {
  std::string name = log.headValue("experiment").value_or("");
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '_' || c == ' '; }, '-');
  // Whole words: "elbow" is no "bow". The release of a whole robot has its own columns.
  if (name.starts_with("body-")) return nullptr;
  const auto plot = std::find_if(kPlots.begin(), kPlots.end(), [&](const ExperimentPlot& p) {
    return ("-" + name + "-").find("-" + std::string{p.word} + "-") != name.npos;
  });
  return plot == kPlots.end() ? nullptr : &*plot;
}

}  // namespace darwinop::plot
