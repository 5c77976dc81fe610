// What of a log can be drawn.
#include "experiments/logs/plot/traces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace darwinop::plot {
namespace {

bool known(const logs::Column& column) {
  return std::any_of(column.values.begin(), column.values.end(), [](double v) { return !std::isnan(v); });
}

const logs::Column* knownColumn(const logs::Log& log, const std::string& name) {
  const logs::Column* column = log.find(name);
  return column != nullptr && known(*column) ? column : nullptr;
}

/// The number of the state "driven": the head of a recording names all states, "0 passive 1 start …".
std::optional<double> drivenState(const logs::Log& log) {
  const std::string states = " " + log.headValue("safety.state").value_or("") + " ";
  const std::size_t word = states.find(" driven ");
  if (word == std::string::npos || word == 0) return std::nullopt;
  const std::size_t number = states.rfind(' ', word - 1) + 1;
  return std::atof(states.substr(number, word - number).c_str());
}

std::size_t firstDrivenRow(const logs::Log& log) {
  const logs::Column* state = log.find("safety.state");
  const auto driven = drivenState(log);
  if (state == nullptr || !driven) return 0;
  const auto row = std::find(state->values.begin(), state->values.end(), *driven);
  return row == state->values.end() ? 0 : static_cast<std::size_t>(row - state->values.begin());
}

}  // namespace

std::vector<JointColumns> jointsOf(const logs::Log& log) {
  std::vector<JointColumns> joints;
  constexpr std::string_view kEnd = ".position";
  for (const logs::Column& column : log.columns) {
    if (!column.name.ends_with(kEnd) || !known(column)) continue;
    const std::string name = column.name.substr(0, column.name.size() - kEnd.size());
    const auto part = [&](const char* what) { return knownColumn(log, name + "." + what); };
    const logs::Column* sent = part("commanded");
    joints.push_back({name, &column, sent != nullptr ? sent : part("asked"), part("load"), part("asked"),
                      part("asked_speed"), part("asked_torque"), part("asked_p_gain"), part("asked_torque_on")});
  }
  if (const logs::Column* position = knownColumn(log, "pos_rad")) {
    const logs::Column* goal = knownColumn(log, "goal_rad");
    joints.push_back({"joint", position, goal, knownColumn(log, "load_pct"), goal, nullptr, nullptr, nullptr,
                      knownColumn(log, "torque_on")});
  }
  return joints;
}

double range(const logs::Column* column, std::size_t from_row) {
  double low = INFINITY, high = -INFINITY;
  for (std::size_t i = from_row; column != nullptr && i < column->values.size(); ++i) {
    if (!std::isfinite(column->values[i])) continue;
    low = std::min(low, column->values[i]);
    high = std::max(high, column->values[i]);
  }
  return high >= low ? high - low : 0;
}

std::size_t startRow(const logs::Log& log) {
  if (!log.headValue("experiment")) return 0;
  const std::size_t driven = firstDrivenRow(log);
  std::size_t start = log.rows();
  for (const JointColumns& joint : jointsOf(log)) {
    if (joint.asked == nullptr) continue;
    const std::vector<double>& asked = joint.asked->values;
    for (std::size_t row = driven + 1; row < start; ++row)
      if (asked[row] != asked[row - 1] && !std::isnan(asked[row - 1])) start = row;
  }
  return start == log.rows() ? driven : start;
}

std::size_t endRow(const logs::Log& log) {
  const logs::Column* state = log.find("safety.state");
  const auto driven = drivenState(log);
  if (state == nullptr || !driven || !log.headValue("experiment")) return log.rows();
  const auto last = std::find(state->values.rbegin(), state->values.rend(), *driven);
  return last == state->values.rend() ? log.rows() : static_cast<std::size_t>(state->values.rend() - last);
}

std::vector<double> timeFrom(const logs::Log& log, std::size_t row) {
  std::vector<double> time(log.rows());
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = log.seconds(i) - log.seconds(row);
  return time;
}

Curve trace(std::vector<double> x, const logs::Column& y) {
  Curve curve;
  const std::size_t rows = std::min(x.size(), y.values.size());
  std::size_t known = 0, alone = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    if (!std::isfinite(y.values[i])) continue;
    ++known;
    const bool before = i > 0 && std::isfinite(y.values[i - 1]);
    const bool after = i + 1 < rows && std::isfinite(y.values[i + 1]);
    if (!before && !after) ++alone;
  }
  if (2 * alone <= known) {
    curve.x = std::move(x);
    curve.y = y.values;
    return curve;
  }
  curve.style = Style::kMarks;
  for (std::size_t i = 0; i < rows; ++i)
    if (std::isfinite(y.values[i])) {
      curve.x.push_back(x[i]);
      curve.y.push_back(y.values[i]);
    }
  return curve;
}

std::string withUnit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

}  // namespace darwinop::plot
