// Search ranges of an effect in a given servo. The catalogue's are those of an MX-28.
#pragma once

#include <vector>

#include "gap/fit/unknown.hpp"

namespace darwinop::gap {

/// As unknownsOf() without a servo, but friction is proportional to the stall torque: a gear that is made for ten times
/// the torque has ten times the friction; and an error of the armature is to the armature.
std::vector<Unknown> unknownsOf(const twin::EffectInfo& info, const twin::ServoParameters& servo, bool refined = false,
                                const Place& place = {});

}  // namespace darwinop::gap
