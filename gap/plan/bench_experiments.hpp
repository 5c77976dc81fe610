// Bench experiments that the delivered set lacks: those that the catalogue names to distinguish effects.
#pragma once

#include <vector>

#include "gap/plan/arm_setup.hpp"

namespace darwinop::gap {

std::vector<experiments::Experiment> benchExperiments(const ArmSetup& stand);

}  // namespace darwinop::gap
