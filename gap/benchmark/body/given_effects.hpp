// Effects of given place and size, hidden in a robot.
#pragma once

#include "gap/benchmark/body/body_key.hpp"
#include "gap/benchmark/body/body_physics.hpp"

namespace darwinop::gap {

/// Hides `effect` and adds it to the key. Numbers by the keys of an answer, in its units; one that is not there is
/// neutral. Throws std::logic_error for an effect that no catalogue has.
void hide(const BodyKeyEffect& effect, const BodyCase& plan, BodyTruth& truth, BodyKey& key);

}  // namespace darwinop::gap
