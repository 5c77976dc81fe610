// Velocities of coupled joints with dry friction after one step.
#pragma once

#include "gap/plant/body/limb_dynamics.hpp"

namespace darwinop::gap {

/// Impulses of dry friction and of mechanical stops in one step, N m s; kept from step to step as the first guess.
struct JointImpulses {
  LimbVector friction, stop;
};

/// `free`: velocities without friction, rad/s. `inverse`: of the mass matrix. `greatest`: impulse of sliding friction.
/// `low`, `high`: velocities that the stops leave; infinite: far from a stop. A joint held by friction returns 0.
LimbVector withFriction(const LimbVector& free, const LimbMatrix& inverse, const LimbVector& greatest,
                        const LimbVector& low, const LimbVector& high, JointImpulses& impulses);

}  // namespace darwinop::gap
