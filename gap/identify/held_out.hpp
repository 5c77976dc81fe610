// What held-out logs have to say about a set of effects: they can withdraw it, or vouch for it.
#pragma once

#include "gap/identify/fitted_model.hpp"
#include "gap/identify/identification.hpp"

namespace darwinop::gap {

/// The error on the held-out logs, rms or mean, grows by more than fresh noise would make it. False without such logs.
bool worsensHeldOut(const Study& study, const Hypothesis& model, double floor_rad);

/// The held-out logs are predicted to within thresholds::kLeastGapFloors, and without any one of the effects, with
/// every number of the baseline free to make up for it, they are not. False without such logs.
bool predictsHeldOut(const FittedModel& fitted);

/// The baseline again: `unknown`, its effects and their model withdrawn. `worsens`: because of the held-out logs.
void withdraw(const Study& study, bool worsens, Identification& found);

}  // namespace darwinop::gap
