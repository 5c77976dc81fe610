// What a servo and its arm can do physically, by the numbers of the case, with room for their errors.
#pragma once

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Bounds on how registers of a servo change. Numbers of a case are often a third off, so each bound has a factor 2.
struct PhysicalLimits {
  double speed_rad_s;    // twice the no-load speed, or a fall of the arm from the top
  double accel_rad_s2;   // twice stall torque and weight over the inertia
  double low_v, high_v;  // at the servo, from the greatest to the least current through the greatest sag
  double heating_k_s;    // with all of the stall power in the winding
  double encoder_step_rad;
};

/// `volt_v`: median of the log; NaN: the voltage has no bounds.
PhysicalLimits limitsOf(const Case& c, const Trajectory& log, double volt_v);

}  // namespace darwinop::gap
