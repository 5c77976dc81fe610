// The table of all effects. A new one: a file beside this one, and a row in catalogue.cpp; docs/twin/add-an-effect.md.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

/// In the order in which they act.
std::span<const EffectInfo* const> catalogue();
/// Null: no such effect.
const EffectInfo* findEffect(std::string_view id);
/// Whatever `effect` is easily taken for, or that is taken for it: who is in whose list does not matter. In the order
/// of the catalogue; an id that is no effect is left out.
std::vector<const EffectInfo*> doublesOf(const EffectInfo& effect);

}  // namespace darwinop::twin
