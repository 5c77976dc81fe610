// One more effect: all suspects looked at, the promising fitted, the best settled, each against the others.
#pragma once

#include "gap/name/replicas.hpp"
#include "gap/name/screen.hpp"
#include "gap/name/settled.hpp"

namespace darwinop::gap {

/// Candidates for the next effect, best first, all on the noise of the best; each has the effects of `present` and one
/// more. `only`: nothing but these are tried; empty: all that the screen has.
std::vector<Settled> contest(const Settled& present, const Screen& screen,
                             const std::vector<const twin::EffectInfo*>& only = {});

/// The same, but on the noise of `present`, and not only those near the best: the six that fit best.
std::vector<Settled> heats(const Settled& present, const Screen& screen);

}  // namespace darwinop::gap
