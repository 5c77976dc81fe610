// Goals that jump, and what a joint makes of them.
#include "experiments/logs/plot/steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace darwinop::plot {
namespace {

constexpr double kArrived = 0.05;    // rad: more than a servo leaves by friction at a usual gain, little of a sweep
constexpr double kSlow = 0.2;        // rad/s
constexpr double kLong = 2;          // s
constexpr double kTorqueJump = 0.3;  // N m
constexpr double kJump = 0.2;        // rad from one row to the next: no goal that slides does that in 16 ms

/// -1, 0 or 1: which way the goal slides slowly at this row; over eight rows, as a controller may miss one.
int slowWay(const logs::Log& log, const std::vector<double>& asked, std::size_t row) {
  const std::size_t before = row < 4 ? 0 : row - 4, after = std::min(row + 4, asked.size() - 1);
  const double rate = (asked[after] - asked[before]) / (log.seconds(after) - log.seconds(before));
  if (!(std::abs(rate) < kSlow) || std::abs(rate) < 1e-4) return 0;
  return rate > 0 ? 1 : -1;
}

template <class F>
std::vector<Stretch> stretches(std::size_t from, std::size_t rows, F&& same) {
  std::vector<Stretch> found;
  for (std::size_t row = from; row < rows; ++row) {
    if (!same(row)) continue;
    if (found.empty() || found.back().end != row) found.push_back({row, row});
    found.back().end = row + 1;
  }
  return found;
}

}  // namespace

std::vector<Step> largeSteps(const JointColumns& joint, std::size_t from_row) {
  std::vector<Step> steps;
  if (joint.asked == nullptr) return steps;
  const std::vector<double>& asked = joint.asked->values;
  for (std::size_t row = std::max<std::size_t>(from_row, 1); row < asked.size(); ++row) {
    if (!(std::abs(asked[row] - asked[row - 1]) > kJump)) continue;
    std::size_t end = row + 1;
    while (end < asked.size() && asked[end] == asked[row]) ++end;
    steps.push_back({row, end, asked[row - 1], asked[row]});
  }
  double largest = 0;
  for (const Step& step : steps) largest = std::max(largest, std::abs(step.to - step.from));
  std::erase_if(steps, [&](const Step& step) { return std::abs(step.to - step.from) < 0.8 * largest; });
  return steps;
}

double arrival(const logs::Log& log, const JointColumns& joint, const Step& step) {
  std::size_t row = step.end;
  while (row > step.begin && std::abs(joint.position->values[row - 1] - step.to) < kArrived) --row;
  if (row == step.end) return std::numeric_limits<double>::quiet_NaN();
  return log.seconds(row) - log.seconds(step.begin);
}

std::vector<Stretch> slowStretches(const logs::Log& log, const JointColumns& joint) {
  if (joint.asked == nullptr) return {};
  const std::vector<double>& asked = joint.asked->values;
  std::vector<Stretch> found;
  for (const int direction : {-1, 1})
    for (const Stretch& s :
         stretches(0, asked.size(), [&](std::size_t row) { return slowWay(log, asked, row) == direction; }))
      if (log.seconds(s.end - 1) - log.seconds(s.begin) >= kLong) found.push_back(s);
  const auto way = [&](const Stretch& s) { return std::abs(asked[s.end - 1] - asked[s.begin]); };
  double furthest = 0;
  for (const Stretch& s : found) furthest = std::max(furthest, way(s));
  std::erase_if(found, [&](const Stretch& s) { return way(s) < 0.5 * furthest; });
  std::sort(found.begin(), found.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
  return found;
}

std::vector<Stretch> limpStretches(const JointColumns& joint, std::size_t from_row) {
  return stretches(from_row, joint.position->values.size(), [&](std::size_t row) {
    return (joint.torque != nullptr && joint.torque->values[row] == 0) ||
           (joint.torque_on != nullptr && joint.torque_on->values[row] == 0);
  });
}

Stretch torqueSlope(const JointColumns& joint) {
  Stretch best;
  double most = 0;
  if (joint.torque == nullptr) return best;
  const std::vector<double>& torque = joint.torque->values;
  for (std::size_t begin = 0, row = 1; row <= torque.size(); ++row) {
    if (row < torque.size() && std::abs(torque[row] - torque[row - 1]) < kTorqueJump) continue;
    const double slid = std::abs(torque[row - 1] - torque[begin]);
    if (slid > most) {
      most = slid;
      best = {begin, row};
    }
    begin = row;
  }
  return best;
}

}  // namespace darwinop::plot
