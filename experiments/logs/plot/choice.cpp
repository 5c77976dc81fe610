// Selects the curves of a log.
#include "experiments/logs/plot/choice.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

#include "experiments/logs/plot/messages.hpp"
#include "experiments/logs/plot/traces.hpp"

namespace darwinop::plot {
namespace {

constexpr double kMoves = 0.01;  // rad, about six encoder steps: above the noise of a joint at rest
constexpr std::size_t kJointsShown = 6;
constexpr std::size_t kColumnsShown = 32;

bool matches(const logs::Column& column, const std::string& pattern) {
  return fnmatch(pattern.c_str(), column.name.c_str(), 0) == 0 ||
         fnmatch(pattern.c_str(), withUnit(column.name, column.unit).c_str(), FNM_NOESCAPE) == 0;
}

bool matchesAny(const logs::Column& column, const std::vector<std::string>& patterns) {
  return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& p) { return matches(column, p); });
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream{text};
  return {std::istream_iterator<std::string>{stream}, {}};
}

void addAxes(std::vector<LogCurve>& pieces, const logs::Log& log, const std::vector<double>& x,
             const std::string& device, const std::string& what) {
  for (const char* axis : {"x", "y", "z"})
    if (const logs::Column* column = log.find(device + "." + axis); range(column) > 0)
      pieces.push_back({device, column->name, axis, withUnit(what, column->unit), trace(x, *column)});
}

}  // namespace

std::vector<std::string> movingJoints(const std::vector<logs::Log>& all, std::vector<std::string>& notes) {
  std::vector<std::string> named;
  for (const logs::Log& log : all)
    for (const std::string& joint : words(log.headValue("joints").value_or("")))
      if (std::find(named.begin(), named.end(), joint) == named.end()) named.push_back(joint);
  if (!named.empty()) return named;
  std::vector<std::string> order;
  std::map<std::string, double> motion;
  for (const logs::Log& log : all)
    for (const JointColumns& joint : jointsOf(log)) {
      const double moved = std::max(range(joint.position), range(joint.goal));
      if (moved < kMoves) continue;
      if (!motion.contains(joint.name)) order.push_back(joint.name);
      motion[joint.name] = std::max(motion[joint.name], moved);
    }
  if (order.size() <= kJointsShown) return order;
  std::vector<std::string> by_motion = order;
  std::stable_sort(by_motion.begin(), by_motion.end(),
                   [&](const std::string& a, const std::string& b) { return motion[a] > motion[b]; });
  std::string left_out;
  for (std::size_t i = kJointsShown; i < by_motion.size(); ++i) {
    left_out.append(left_out.empty() ? "" : ", ").append(by_motion[i]);
    std::erase(order, by_motion[i]);
  }
  notes.push_back("only the " + std::to_string(kJointsShown) + " joints that move most are shown; also moving: " +
                  left_out + " (--columns '" + by_motion[kJointsShown] + ".*' shows one)");
  return order;
}

std::vector<LogCurve> defaultCurves(const logs::Log& log, const std::vector<double>& x,
                                    const std::vector<std::string>& joints) {
  std::vector<LogCurve> pieces, loads;
  for (const JointColumns& joint : jointsOf(log)) {
    if (std::find(joints.begin(), joints.end(), joint.name) == joints.end()) continue;
    const std::string angle = withUnit("angle", joint.position->unit);
    if (joint.goal != nullptr) {
      pieces.push_back({joint.name, joint.name, "goal", angle, trace(x, *joint.goal)});
      pieces.back().curve.dashed = true;
    }
    pieces.push_back({joint.name, joint.name, "measured", angle, trace(x, *joint.position)});
    if (joint.load != nullptr)
      loads.push_back({"load", "load of " + joint.name, joint.name,
                       withUnit("load", joint.load->unit.empty() ? "1 = maximum torque" : joint.load->unit),
                       trace(x, *joint.load)});
  }
  std::move(loads.begin(), loads.end(), std::back_inserter(pieces));
  // The header of an experiment names the relevant sensors; other logs show all.
  const std::string sensors =
      log.headValue("sensors").value_or(log.headValue("experiment") ? "" : "gyro accelerometer");
  if (sensors.find("gyro") != std::string::npos) addAxes(pieces, log, x, "gyro", "rate");
  if (sensors.find("accelerometer") != std::string::npos) addAxes(pieces, log, x, "accelerometer", "acceleration");
  return pieces;
}

void checkPatterns(const std::vector<logs::Log>& all, const std::vector<std::string>& patterns) {
  for (const std::string& pattern : patterns) {
    const auto has = [&](const logs::Log& log) {
      return std::any_of(log.columns.begin(), log.columns.end(),
                         [&](const logs::Column& c) { return matches(c, pattern); });
    };
    if (std::any_of(all.begin(), all.end(), has)) continue;
    try {
      (void)all.front().column(pattern);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(std::string{error.what()} + "; * stands for any text, as in --columns 'Neck.*'");
    }
  }
}

std::vector<LogCurve> selectedCurves(const logs::Log& log, const std::vector<double>& x,
                                     const std::vector<std::string>& patterns) {
  std::vector<LogCurve> pieces;
  for (const logs::Column& column : log.columns) {
    if (!matchesAny(column, patterns) ||
        std::none_of(column.values.begin(), column.values.end(), [](double v) { return v == v; }))
      continue;
    const std::string unit = column.unit.empty() ? messages::kNoUnit : column.unit;
    pieces.push_back({unit, column.name, column.name, withUnit("", unit), trace(x, column)});
    pieces.back().y_label = column.unit.empty() ? "" : unit;
  }
  if (pieces.size() > kColumnsShown)
    throw std::runtime_error(log.file + ": the patterns match " + std::to_string(pieces.size()) + " columns, at most " +
                             std::to_string(kColumnsShown) + " can be shown; name fewer with --columns");
  return pieces;
}

}  // namespace darwinop::plot
