// Which effects the logs cannot tell from others, whatever a fit prefers.
#pragma once

#include <vector>

#include "gap/identify/effect_set.hpp"

namespace darwinop::gap {

/// Candidates that are observable by certain features of logs, none of which the fitted logs of the case have.
std::vector<const twin::EffectInfo*> effectsNotShown(const Case& given);

}  // namespace darwinop::gap
