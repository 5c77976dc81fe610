// Gait parameters of the public header, converted and checked.
#pragma once

#include "DARwInOPGaitManager.hpp"
#include "managers/gait/parameters.hpp"

namespace managers {

[[nodiscard]] DARwInOPGaitManager::GaitParameters publicParameters(const darwinop::gait::Parameters& inside);

/// Overwrites the parameters of the public header; the others stay.
void assign(darwinop::gait::Parameters& inside, const DARwInOPGaitManager::GaitParameters& parameters);

}  // namespace managers
