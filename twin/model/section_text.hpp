// The lines of an effect's section.
#pragma once

#include <string>
#include <vector>

#include "twin/model/model.hpp"
#include "twin/model/sections.hpp"

namespace darwinop::twin {

/// "[effect coulomb Neck]", "friction = 0.025 N m". Throws std::runtime_error for a setting that fits no effect.
std::vector<std::string> sectionLines(const EffectSetting& setting);

}  // namespace darwinop::twin
