// Sampling times of a device with a sampling period.
#pragma once

namespace darwinop::webots_api {

/// True if a sample is due; `due_s` is then set to the next time. Times are on a grid, so that a period of 40 ms in
/// steps of 16 ms is 40 ms on average. Initial `due_s`: below 0.
inline bool isDue(double& due_s, double time_s, int period_ms) {
  constexpr double kHalfCycle = 0.004;  // half of the shortest period: tolerance for steps that end early by jitter
  if (time_s + kHalfCycle < due_s) return false;
  const double period_s = period_ms / 1000.0;
  due_s = due_s >= 0 && due_s + period_s > time_s ? due_s + period_s : time_s + period_s;
  return true;
}

}  // namespace darwinop::webots_api
