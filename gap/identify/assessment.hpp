// Assessment of a fitted model: misfit, prior conflicts, intervals, and the verdict that follows from them.
#pragma once

#include "gap/identify/bootstrap.hpp"
#include "gap/identify/identification.hpp"

namespace darwinop::gap {

/// Cost of the fit against the same model's cost on its own bootstrap replicas, in standard deviations.
double misfitOf(const FittedModel& fitted, const Bootstrap& bootstrap);
/// Largest distance of a number from its prior, in prior standard deviations; never negative.
double largestPriorSigma(const FittedModel& fitted);
/// Gain below which an effect of the model is dropped. An effect that stands for a baseline number needs `threshold`
/// unless it moves that number well beyond its prior.
double leastGain(const Study& study, const Hypothesis& model, const twin::EffectInfo& effect, double threshold);
/// Numbers beyond thresholds::kPriorConflictSigmas.
std::vector<PriorConflict> priorConflictsOf(const FittedModel& fitted);
/// `excess`: cost over expected cost, 1 for a right model; a larger one widens the intervals.
std::vector<Estimate> estimatesOf(const FittedModel& fitted, const twin::EffectInfo& effect, double excess);
/// A parameter without prior is at the end of its range: the effect then stands in for something else.
bool isAtItsBound(const FittedModel& fitted, const twin::EffectInfo& effect);
/// Every parameter is so close to neutral that it only reflects rounding in two simulators.
bool isNegligible(const FittedModel& fitted, const twin::EffectInfo& effect);
/// The fitted hypothesis, with parameters that the data do not determine set to neutral.
Hypothesis withoutUndetermined(const FittedModel& fitted);

/// Rms position error that noise alone produces, rad.
double floorOf(const FittedModel& fitted);
double floorOf(const Evidence& evidence);  // NaN without logs

Verdict verdictOf(const Identification& found);
/// On a roughly known baseline that leaves a remainder, by the mean position errors.
Verdict verdictOfRough(const Identification& found, double mean_before_rad, double mean_after_rad);
/// Of effects that are accepted: `ambiguous` if the data do not exclude a rival, else `named`.
Verdict namedOrAmbiguous(const Identification& found);

}  // namespace darwinop::gap
