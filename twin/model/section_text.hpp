// Formats the section of an effect.
#pragma once

#include <string>
#include <vector>

#include "twin/model/model.hpp"
#include "twin/model/sections.hpp"

namespace darwinop::twin {

/// "[effect coulomb Neck]", "friction = 0.025 N m". Throws std::runtime_error if values and parameters differ in
/// number.
std::vector<std::string> sectionLines(const EffectSetting& setting);

}  // namespace darwinop::twin
