// Every tuned constant of the identification, with its unit, what it does, and the evidence for its value.
//
// "No evidence yet": chosen by judgement; nobody has measured what half and twice the value do to a suite.
#pragma once

#include <cstddef>
#include <cstdint>

namespace darwinop::gap::thresholds {

// ---- Assessment of a fitted model (gap/identify/assessment.cpp) ----

/// Bootstrap standard deviations of a right model's cost. Above, something is missing. No evidence yet.
inline constexpr double kMisfitSigmas = 4;
/// Prior standard deviations. A baseline number beyond is reported as a prior conflict. From the specification.
inline constexpr double kPriorConflictSigmas = 3;
/// Prior standard deviations. Beyond, effects that stand for this number are tried first. No evidence yet.
inline constexpr double kPriorSuspectSigmas = 2.4;
/// Cost. Least gain of an effect that releases such a number: most of what its sigmas cost. No evidence yet.
inline constexpr double kPriorReleaseGain = 4;
/// Half width of a 90 % interval of a normal distribution, in standard deviations. Statistics, not tuned.
inline constexpr double kInterval90 = 1.645;
/// Ratio of cost to expected cost. Up to here a model counts as right, and its intervals are not widened. No evidence
/// yet.
inline constexpr double kRightCostRatio = 1.15;
/// Samples at 16 ms whose errors are correlated where a model is wrong; widens intervals. From the specification
/// (N_eff = N / 8).
inline constexpr double kCorrelatedSamples = 8;
/// Share of a parameter: its 90 % interval is never narrower. A limit of 80 rad/s2 came back 0.3 % off from the logs of
/// another simulator.
inline constexpr double kFinestInterval = 0.004;
/// Share of a parameter's range. Closer to an end than this counts as at the bound. No evidence yet.
inline constexpr double kBoundMargin = 1e-3;
/// Share of a parameter's range. Closer to neutral than this is no finding: the encoder cannot resolve a delay, a play
/// or a gain that small.
inline constexpr double kNegligibleShare = 3e-4;
/// Noise floors that may remain after an effect that removes kExplainedGapShare of the gap. No evidence yet.
inline constexpr double kRemainingFloors = 3;
/// Share of the gap that has to be removed where the misfit is still significant. No evidence yet.
inline constexpr double kExplainedGapShare = 0.85;
/// Noise floors. A smaller gap without a named effect is `cannot_tell`, not `unknown`. From the specification.
inline constexpr double kLeastGapFloors = 2;

// ---- Bootstrap (gap/identify/bootstrap.cpp) ----

/// Simulated replicas of the logs: the 99th percentile needs about two hundred. From the specification.
inline constexpr int kBootstrapRuns = 200;
/// Replicas where the model is plainly wrong (kPlainCost): the threshold matters less there.
inline constexpr int kFewBootstrapRuns = 40;
/// Cost per residual above which a model is plainly wrong for that purpose. No evidence yet.
inline constexpr double kPlainCost = 1.5;
/// Seeds of replicas start here, apart from those of the noise model.
inline constexpr std::uint64_t kBootstrapSeed = 900'000'000;

// ---- Selection (gap/identify/selection.cpp, select.cpp, prune.cpp) ----

/// Times the chance gain that an effect has to gain where noise alone explains the residual. No evidence yet.
inline constexpr double kChanceMargin = 1.3;
/// Least share of the cost beyond noise that an effect has to remove: any effect happens to remove some. From the
/// specification (5 % of the excess gap).
inline constexpr double kLeastExcessShare = 0.05;
/// Share of the cost beyond noise that an effect at its bound has to remove to be accepted. No evidence yet.
inline constexpr double kBoundExcessShare = 0.8;
/// Cost per residual beyond noise. Above, a further effect must improve leave-one-out predictions. No evidence yet.
inline constexpr double kCrossValidateCost = 2;
/// Prior standard deviations. With all other numbers fixed, a moved number is a finding beyond. No evidence yet.
inline constexpr double kFixedNumberSigmas = 1.5;
/// Effects that are looked for with all numbers fixed; more are a sign that the numbers are off. No evidence yet.
inline constexpr int kMaxEffectsFixed = 2;
/// Share of the gap. If two effects leave more, the selection stops, and its effects are not named. No evidence yet.
inline constexpr double kHopelessGapShare = 0.5;
/// A remaining gap below all three is a difference in how an effect is modelled, not a further effect: bootstrap
/// standard deviations, noise floors, share of the gap. No evidence yet.
inline constexpr double kNearMisfitSigmas = 60, kNearFloors = 1.5, kNearGapShare = 0.15;
/// Ratio of mean position errors on held-out logs, after over before, above which the effects are withdrawn, and noise
/// floors by which it has to grow. None of 121 cases of two suites came near them.
inline constexpr double kHeldOutErrorRatio = 1.5, kHeldOutFloors = 2;
/// Twice the log evidence within which a rival is not excluded: odds of 150 to 1; of 7 to 1 against a rival with more
/// free parameters. The scale of Kass and Raftery (1995); no evidence yet.
inline constexpr double kRivalEvidence = 10, kLargerRivalEvidence = 4;

// ---- Shortlist of candidates (gap/identify/shortlist.cpp) ----

/// Effects whose starts are refined, by predicted gain; the second for a roughly known baseline. No evidence yet.
inline constexpr std::size_t kRefinedEffects = 10, kRefinedEffectsRough = 16;
/// Starts of each effect that are refined. From the specification (2 to 3).
inline constexpr std::size_t kStartsPerEffect = 3;
/// Effects that are fitted. From the specification (refine the best 5).
inline constexpr std::size_t kFittedEffects = 6;
/// Fitted models that are compared under the noise of the best. No evidence yet.
inline constexpr std::size_t kComparedModels = 5;
/// Only models this close to the best are compared: share of its gain, or cost. No evidence yet.
inline constexpr double kNearGainShare = 0.15, kNearCost = 60;
/// Prior cost. Above, the fit may have pulled the baseline numbers away, so it is repeated from their expected values.
/// No evidence yet.
inline constexpr double kPulledPriorCost = 15;
/// Twice the log evidence by which a rival must lead under the best model's noise to be refitted under its own. No
/// evidence yet.
inline constexpr double kRivalLead = 2;

// ---- Refit with matching noise (gap/identify/fitted_model.cpp) ----

/// Total cost. A round that gains less is the last. No evidence yet.
inline constexpr double kRefitGain = 0.5;
/// Squared standard deviations. A fit that moved less keeps its noise model. No evidence yet.
inline constexpr double kRefitMovement = 30;
/// Simulations per log behind a noise model. Fewer leave modes out, which then look like an effect; where the model
/// discrepancy counts as noise, fewer suffice.
inline constexpr int kNoiseRuns = 96, kDiscrepancyNoiseRuns = 24;

// ---- Cross-validation (gap/identify/cross_validation.cpp) ----

/// Solver iterations, starting at the fit to all logs. No evidence yet.
inline constexpr int kCrossValidationIterations = 6;

// ---- Screen and refined starts (gap/identify/screen.cpp, refined_start.cpp, ripple_starts.cpp) ----

/// Periods per revolution up to which a torque ripple is looked for. From the catalogue's range.
inline constexpr int kMaxRipplesPerTurn = 60;
/// N m. Ripple whose response is linear: small against what moves an arm.
inline constexpr double kScreenRippleTorque = 0.004;
/// Share of the remaining squares. A Gauss-Newton step that gains less is the last. No evidence yet.
inline constexpr double kRefineGain = 1e-3;
/// Prior standard deviations that the linear model may move a number by. No evidence yet.
inline constexpr double kRefinePriorSigmas = 2;
/// s. Length of a shooting window for ripples: 0.02 N m move an arm with 0.2 kg by 20 mrad in it, seldom into another
/// detent.
inline constexpr double kRippleWindow = 0.12;
/// N m. Ripple that is simulated in such a window.
inline constexpr double kRippleTorque = 0.02;
/// Ripple counts that become candidates, no two of them neighbours. No evidence yet.
inline constexpr std::size_t kRippleCandidates = 3;
/// Reweightings of the robust linear fit. No evidence yet.
inline constexpr int kRippleReweightings = 3;
/// s. Firmware period in such a window: a shorter one changes nothing there.
inline constexpr double kRipplePeriod = 0.001;

// ---- Measured voltage against supply sag (gap/identify/supply_check.cpp) ----

/// ohm. Wiring between where the servo measures its voltage and where it draws its current. No evidence yet.
inline constexpr double kWiringOhm = 0.5;
/// Standard errors by which a fitted sag must exceed the measured one to be contradicted. No evidence yet.
inline constexpr double kSupplyErrors = 4;
/// ohm. With a larger standard error the logs disagree, and nothing is concluded. No evidence yet.
inline constexpr double kSupplyUncertainOhm = 1;

// ---- Roughly known baselines (gap/identify/rough_selection.cpp) ----

/// Relative prior standard deviation of kt or resistance from which the motor counts as not measured. No evidence yet.
inline constexpr double kRoughPrior = 0.1;
/// Cost. Least gain of an effect that every servo has: predictions improve from 2 on (Akaike 1974).
inline constexpr double kCommonEffectGain = 2;
/// Cost. Least gain of a rarer effect: with a dozen to choose from, one gains some by chance. No evidence yet.
inline constexpr double kRareEffectGain = 10;
/// Log ratio of leave-one-out errors that a rarer effect has to reach. No evidence yet.
inline constexpr double kRareEffectHelp = 0.1;
/// Rarer effects per round that are cross-validated. A matter of run time.
inline constexpr std::size_t kCrossValidatedEffects = 3;
/// Rarer effects that are added: a round takes half a minute, and the second depends on the first.
inline constexpr int kMaxRareEffects = 1;
/// Share of the mean error. If more remains, the effects found may stand for something else. No evidence yet.
inline constexpr double kRoughErrorShare = 0.2;

}  // namespace darwinop::gap::thresholds
