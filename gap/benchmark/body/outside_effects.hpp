// What no catalogue has: a cable that pulls, a push, a part that comes loose.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/random.hpp"
#include "gap/benchmark/body/body_key.hpp"
#include "gap/benchmark/body/body_physics.hpp"

namespace darwinop::gap {

inline constexpr std::string_view kCable = "cable", kPush = "push", kLoose = "loose_part";
inline constexpr std::array kOutsideEffects{kCable, kPush, kLoose};

/// One of them in a drawn place and size. The key says where.
void hideOutside(const std::string& id, const BodyCase& plan, Rng& rng, BodyTruth& truth, BodyKey& key);

}  // namespace darwinop::gap
