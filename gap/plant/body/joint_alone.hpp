// One servo of a robot, as the bench of gap/plant/bench has it: for the blocks that do not depend on what it moves.
#pragma once

#include "gap/case/body/body_case.hpp"
#include "gap/plant/block.hpp"
#include "gap/plant/block_residuals.hpp"

namespace darwinop::gap {

/// Blocks of a joint that its own signals close.
inline constexpr std::array kBlocksOfJointAlone{Block::kController, Block::kSupply};

/// The model of a robot: an effect of a single joint has that joint as its place.
Hypothesis bodyBaselineOf(const BodyCase& given);
/// The servo of one joint. An effect at its place replaces that of all joints.
Hypothesis atJoint(const Hypothesis& robot, Joint joint);

/// Residuals of one of kBlocksOfJointAlone. `log`: one of given.joints.logs.
BlockResiduals jointResiduals(Block block, const BodyCase& given, const Trajectory& log, const Hypothesis& robot);

}  // namespace darwinop::gap
