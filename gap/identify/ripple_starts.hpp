// Starts for a position-locked torque ripple, from short shooting windows.
#pragma once

#include <vector>

#include "gap/identify/screen.hpp"

namespace darwinop::gap {

/// The effect whose torque repeats around the turn: amplitude, count a turn, phase.
bool isRipple(const twin::EffectInfo& effect);

/// The ripples that best explain where short simulations from measured states end, the best first, without a predicted
/// gain. Empty where no window responds to one, or the model has one. Over a whole log a strong ripple lets a released
/// arm rest in another detent, so no linear prediction finds its count; a window of a tenth of a second stays in one
/// detent.
std::vector<Candidate> ripplesOf(const FittedModel& present);

}  // namespace darwinop::gap
