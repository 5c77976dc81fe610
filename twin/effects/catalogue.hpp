// Table of all effects. To add one: a source file in this folder and a row in catalogue.cpp;
// docs/twin/add-an-effect.md.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

/// In the order in which they act.
std::span<const EffectInfo* const> catalogue();
/// Effects of the program itself, which act after those of the table. None, unless the program defines this function
/// (chosen by the linker: the definition here is weak).
std::span<const EffectInfo* const> addedEffects();
/// Null if no effect has this id.
const EffectInfo* findEffect(std::string_view id);
/// The first effect whose first parameter has this role. Null if there is none.
const EffectInfo* effectWith(ParameterRole role);
/// Effects confounded with `effect`: symmetric closure of EffectInfo::confused_with, in catalogue order. Unknown ids
/// are skipped.
std::vector<const EffectInfo*> doublesOf(const EffectInfo& effect);

}  // namespace darwinop::twin
