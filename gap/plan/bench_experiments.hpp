// Experiments for a bench that the battery has not: the ones that the catalogue names to tell effects apart.
#pragma once

#include <vector>

#include "gap/plan/arm_setup.hpp"

namespace darwinop::gap {

std::vector<experiments::Experiment> benchExperiments(const ArmSetup& stand);

}  // namespace darwinop::gap
