// When a device with a sampling period has its turn.
#pragma once

namespace darwinop::webots_api {

/// True: now, and `due_s` becomes the next time. On a grid, so that 40 ms asked for in steps of 16 ms are 40 ms on
/// average. A `due_s` below 0: it had none yet.
inline bool isDue(double& due_s, double time_s, int period_ms) {
  constexpr double kHalfCycle = 0.004;  // of the shortest loop: a step that ends early by jitter still counts
  if (time_s + kHalfCycle < due_s) return false;
  const double period_s = period_ms / 1000.0;
  due_s = due_s >= 0 && due_s + period_s > time_s ? due_s + period_s : time_s + period_s;
  return true;
}

}  // namespace darwinop::webots_api
