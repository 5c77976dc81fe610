// Fits of the most promising candidates for one more effect.
#pragma once

#include "gap/identify/bootstrap.hpp"
#include "gap/identify/screen.hpp"

namespace darwinop::gap {

/// Refines the candidates of the screen, fits the best, and compares those near the best one under its noise, best
/// first. Each model has the effects of `present` and one more. `only`: nothing but these effects; empty: all of the
/// screen.
std::vector<FittedModel> fitCandidates(const FittedModel& present, const Screen& screen,
                                       const std::vector<const twin::EffectInfo*>& only = {});

/// On a roughly known baseline: the effects that fit best under the noise of `present`, best first, however far behind
/// the best one; without Jacobians. `refined`: with their secondary parameters where these earn their place.
std::vector<FittedModel> shortlist(const FittedModel& present, const Screen& screen, bool refined = false);

}  // namespace darwinop::gap
