// Effects that stand for a number of the baseline, such as a mass error or more friction than the baseline has.
#pragma once

#include <string_view>

#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// True: the effect is an error of `number`.
bool isAliasOf(const twin::EffectInfo& effect, std::string_view number);

/// True: the effect only releases a baseline number that has a prior (coulomb where the baseline has dry friction).
bool aliasesAPrior(const Case& data, const twin::EffectInfo& effect);

/// Distance by which `hypothesis`, which has the effect, moves the number that the effect stands for, in standard
/// deviations of its prior. Infinite without such a number or prior.
double priorSigmasMoved(const Case& data, const Hypothesis& baseline, const Hypothesis& hypothesis,
                        const twin::EffectInfo& effect);

}  // namespace darwinop::gap
