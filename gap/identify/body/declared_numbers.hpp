// Effects that are also numbers of the model, which the case declares within a prior: dry and viscous friction of a
// joint, mass and centre of mass of a link.
#pragma once

#include "gap/identify/body/mechanical_effect.hpp"
#include "gap/localize/body/clamped_robot.hpp"

namespace darwinop::gap {

/// Squared prior standard deviations from the declared numbers to the values of the effect, over its places: what the
/// model pays that has no effect and these numbers. Such an effect cannot gain more. Infinity: no such number.
double priorCost(const ClampedRobot& robot, const PlacedMechanics& effect);

/// Moves the numbers of the model there.
void moveNumbers(ClampedRobot& robot, const PlacedMechanics& effect, const BodyHypothesis& about);

}  // namespace darwinop::gap
