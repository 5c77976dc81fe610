// What a fitted set of effects says, and the rules by which it becomes a verdict.
#pragma once

#include "gap/name/naming.hpp"
#include "gap/name/replicas.hpp"

namespace darwinop::gap {

inline constexpr double kMisfit = 4;        // standard deviations of a right model's cost: beyond, something is missing
inline constexpr double kStrained = 3;      // sigma of a prior: beyond, the number is wrong
inline constexpr double kSuspicious = 2.4;  // sigma: effects that mean this number are tried
inline constexpr double kStrainGain = 4;    // of freeing such a number: most of what its sigmas cost
inline constexpr double kPlain = 1.3;       // thresholds that a gain has to pass where noise alone explains all

// A gap that has shrunk to this: what is left is how the effect is written, not another effect.
inline constexpr double kNearMisfit = 60, kNearFloors = 1.5, kNearShare = 0.15;

/// In standard deviations of what the same model shows on data of its own.
double misfitOf(const Settled& fitted, const Replicas& replicas);
/// |sigma| of the number that is farthest out of its prior.
double mostStrained(const Settled& fitted);
/// With less, an effect that was found is needless. Freeing a number that moved no farther than its prior lets it may
/// gain as much by chance as any effect.
double leastGain(const Case& given, const Hypothesis& found, const twin::EffectInfo& effect, double threshold);
/// Those beyond kStrained.
std::vector<Strained> strainedOf(const Settled& fitted);
/// `excess`: cost over what noise makes of it, 1 for a right model; beyond, the intervals grow.
std::vector<Estimate> estimatesOf(const Settled& fitted, const twin::EffectInfo& effect, double excess);
/// An effect that had to be as strong as it can be stands in for something else, unless it explains nearly all.
bool isAtItsBound(const Settled& fitted, const twin::EffectInfo& effect);
/// Every number of the effect is where it does nothing: what such a fit gains comes from how two simulators round.
bool isNextToNothing(const Settled& fitted, const twin::EffectInfo& effect);
/// What was fitted; an effect's number that the data say nothing about is left at its neutral value.
Hypothesis withoutUnseen(const Settled& fitted);
std::vector<std::string> idsOf(const Effects& effects);

/// Rms of measured minus simulated position, closed loop, over the logs for fitting or those for judging; rad.
double gapOf(const Case& given, const Hypothesis& hypothesis, bool score);
/// Mean |measured - simulated| of each log, and of these the mean, rad: a swing that is out of phase counts less.
double meanErrorOf(const Case& given, const Hypothesis& hypothesis, bool score);
/// Gap of a right model: what noise alone makes.
double floorOf(const Settled& fitted);

Verdict verdictOf(const Naming& naming);

}  // namespace darwinop::gap
