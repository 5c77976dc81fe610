// Detects steps, slow ramps and torque-off ranges in a log.
#include "experiments/logs/plot/steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace darwinop::plot {
namespace {

constexpr double kArrived =
    0.05;  // rad: above the steady-state error from friction at the default gain, small against a sweep
constexpr double kSlow = 0.2;        // rad/s
constexpr double kMinDuration = 2;   // s
constexpr double kTorqueJump = 0.3;  // N m
constexpr double kJump = 0.2;        // rad from one row to the next: faster than any continuous goal in 16 ms

/// -1, 0 or 1: direction of a slow ramp at this row; over eight rows, because a controller may miss one.
int slowDirection(const logs::Log& log, const std::vector<double>& requested, std::size_t row) {
  const std::size_t before = row < 4 ? 0 : row - 4, after = std::min(row + 4, requested.size() - 1);
  const double rate = (requested[after] - requested[before]) / (log.seconds(after) - log.seconds(before));
  if (!(std::abs(rate) < kSlow) || std::abs(rate) < 1e-4) return 0;
  return rate > 0 ? 1 : -1;
}

template <class F>
std::vector<RowRange> rangesWhere(std::size_t from, std::size_t rows, F&& same) {
  std::vector<RowRange> found;
  for (std::size_t row = from; row < rows; ++row) {
    if (!same(row)) continue;
    if (found.empty() || found.back().end != row) found.push_back({row, row});
    found.back().end = row + 1;
  }
  return found;
}

}  // namespace

std::vector<GoalStep> largeSteps(const JointColumns& joint, std::size_t from_row) {
  std::vector<GoalStep> steps;
  if (joint.requested == nullptr) return steps;
  const std::vector<double>& requested = joint.requested->values;
  for (std::size_t row = std::max<std::size_t>(from_row, 1); row < requested.size(); ++row) {
    if (!(std::abs(requested[row] - requested[row - 1]) > kJump)) continue;
    std::size_t end = row + 1;
    while (end < requested.size() && requested[end] == requested[row]) ++end;
    steps.push_back({row, end, requested[row - 1], requested[row]});
  }
  double largest = 0;
  for (const GoalStep& step : steps) largest = std::max(largest, std::abs(step.to - step.from));
  std::erase_if(steps, [&](const GoalStep& step) { return std::abs(step.to - step.from) < 0.8 * largest; });
  return steps;
}

double arrival(const logs::Log& log, const JointColumns& joint, const GoalStep& step) {
  const std::vector<double>& position = joint.position->values;
  std::size_t row = step.end;
  // A reading that is missing neither ends an arrival nor proves it.
  while (row > step.begin && !(std::abs(position[row - 1] - step.to) >= kArrived)) --row;
  while (row < step.end && std::isnan(position[row])) ++row;
  if (row == step.end) return std::numeric_limits<double>::quiet_NaN();
  return log.seconds(row) - log.seconds(step.begin);
}

std::vector<RowRange> slowRanges(const logs::Log& log, const JointColumns& joint) {
  if (joint.requested == nullptr) return {};
  const std::vector<double>& requested = joint.requested->values;
  std::vector<RowRange> found;
  for (const int direction : {-1, 1})
    for (const RowRange& s : rangesWhere(
             0, requested.size(), [&](std::size_t row) { return slowDirection(log, requested, row) == direction; }))
      if (log.seconds(s.end - 1) - log.seconds(s.begin) >= kMinDuration) found.push_back(s);
  const auto distance = [&](const RowRange& s) { return std::abs(requested[s.end - 1] - requested[s.begin]); };
  double furthest = 0;
  for (const RowRange& s : found) furthest = std::max(furthest, distance(s));
  std::erase_if(found, [&](const RowRange& s) { return distance(s) < 0.5 * furthest; });
  std::sort(found.begin(), found.end(), [](const RowRange& a, const RowRange& b) { return a.begin < b.begin; });
  return found;
}

std::vector<RowRange> limpRanges(const JointColumns& joint, std::size_t from_row) {
  return rangesWhere(from_row, joint.position->values.size(), [&](std::size_t row) {
    return (joint.torque != nullptr && joint.torque->values[row] == 0) ||
           (joint.torque_on != nullptr && joint.torque_on->values[row] == 0);
  });
}

RowRange torqueSlope(const JointColumns& joint) {
  RowRange best;
  double most = 0;
  if (joint.torque == nullptr) return best;
  const std::vector<double>& torque = joint.torque->values;
  for (std::size_t begin = 0, row = 1; row <= torque.size(); ++row) {
    if (row < torque.size() && std::abs(torque[row] - torque[row - 1]) < kTorqueJump) continue;
    const double change = std::abs(torque[row - 1] - torque[begin]);
    if (change > most) {
      most = change;
      best = {begin, row};
    }
    begin = row;
  }
  return best;
}

}  // namespace darwinop::plot
