// Bench experiments that the delivered set lacks: those that the catalogue names to distinguish effects.
#pragma once

#include <vector>

#include "core/servo_limits.hpp"
#include "gap/plan/arm_setup.hpp"

namespace darwinop::gap {

/// `p_gain`: as experiments count, a register / 8; some experiments have less in other rounds.
std::vector<experiments::Experiment> benchExperiments(const ArmSetup& stand, double p_gain = kDefaultPGain);

}  // namespace darwinop::gap
