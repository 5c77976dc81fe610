// Servo temperature (first-order thermal model) and overload protection. Sources of the numbers: docs/twin/servo.md.
#pragma once

#include "twin/servo/signals.hpp"

namespace darwinop::twin {

/// Winding and case as one thermal mass: heated by copper losses, cooled by the ambient air.
double temperatureAfter(const Signals& s, const ServoParameters& parameters, double dt_s) noexcept;

/// Trips when a stalled servo stays at its torque limit for longer than overload_time_s. Latched until torque is off.
class OverloadGuard {
 public:
  void reset() noexcept { *this = {}; }
  void step(const Signals& s, const ServoParameters& parameters, double dt_s) noexcept;
  [[nodiscard]] bool tripped() const noexcept { return tripped_; }

 private:
  double for_s_ = 0;
  bool tripped_ = false;
};

}  // namespace darwinop::twin
