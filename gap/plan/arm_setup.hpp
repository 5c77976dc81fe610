// The joint of the robot that swings the arm of a case, and the pose of the other joints.
#pragma once

#include <optional>

#include "experiments/format/experiment.hpp"

namespace darwinop::gap {

struct ArmSetup {
  Joint joint = Joint::kShoulderR;
  double hangs_at_rad = 0;             // angle of the joint at which the arm hangs down; a case counts from there
  experiments::ExperimentSetup setup;  // first pose: the arm hangs, or comes as near to it as the joint allows
};

/// Long enough for the way from the start pose to the first pose at the speed that is allowed there.
void takeTimeFor(experiments::ExperimentSetup& setup);

/// `hangs_at_rad`: nothing is what is known of the robot's arms, 0 for another joint.
ArmSetup armSetupFor(Joint joint, std::optional<double> hangs_at_rad = {});

}  // namespace darwinop::gap
