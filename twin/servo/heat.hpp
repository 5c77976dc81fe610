// Temperature of a servo, and its protection against a load that it cannot hold. docs/twin/servo.md says where the
// numbers come from.
#pragma once

#include "twin/servo/signals.hpp"

namespace darwinop::twin {

/// Winding and case as one body of heat: the copper losses warm it, the room cools it.
double temperatureAfter(const Signals& s, const ServoParameters& parameters, double dt_s) noexcept;

/// Overload: the servo stands, gives all that its torque limit allows, and does so for too long. Latches until the
/// torque goes off.
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
