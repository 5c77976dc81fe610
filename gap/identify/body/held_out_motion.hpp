// How well a model predicts the joints in recordings that no fit has used.
#pragma once

#include "gap/localize/body/clamped_robot.hpp"

namespace darwinop::gap {

/// Rms of measured minus simulated positions of all joints in the held-out logs with a clamped trunk, rad; NaN: there
/// are none. Numbers of the model that were fitted within their priors are the fitted ones.
double heldOutError(const ClampedRobot& robot, const BodyHypothesis& hypothesis);
/// The same of the joints of these limbs.
double heldOutErrorIn(const ClampedRobot& robot, const std::vector<std::size_t>& limbs,
                      const BodyHypothesis& hypothesis);
/// No held-out log contradicts a step from one such error to another. NaN before: there are none; NaN only after it:
/// the simulation failed, which contradicts it.
bool holdsUnseen(double before_rad, double after_rad);

}  // namespace darwinop::gap
