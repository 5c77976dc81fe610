// Figures of the key: error of the baseline, its share of noise, and where an effect outside the catalogue shows.
#pragma once

#include "gap/benchmark/make/answer_key.hpp"
#include "gap/benchmark/make/simulate_log.hpp"

namespace darwinop::gap {

/// `measured` and `quiet`: the same bench with and without noise.
void compare(const CasePlan& measured, const CasePlan& quiet, const Truth& truth, Key& key);

}  // namespace darwinop::gap
