// Tuned constants of the identification, with unit, what they do, and the evidence for their values. What half and
// twice of those of one servo do to cases of another simulator: tests/gap/sensitivity.tsv, printed by
// tools/gap-sensitivity.sh. Those of the whole robot and of its floor have not been varied yet.
//
// "No evidence yet": chosen by judgement; none or fewer than five of these cases have shown what another value does.
// Limits of what counts as a plausible recording stand beside their checks in gap/case: they are facts about servos and
// judge data, not models. Constants of planning, on which no verdict depends: gap/plan/thresholds.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace darwinop::gap::thresholds {

// ---- Assessment of a fitted model (gap/identify/assessment.cpp) ----

/// Bootstrap standard deviations of a right model's cost. Above, something is missing.
inline constexpr double kMisfitSigmas = 4;
/// Prior standard deviations. A baseline number beyond is reported as a prior conflict. From the specification.
inline constexpr double kPriorConflictSigmas = 3;
/// Prior standard deviations. Beyond, effects that stand for this number are tried first.
inline constexpr double kPriorTensionSigmas = 2.4;
/// Cost. Least gain of an effect that releases such a number: most of what its sigmas cost.
inline constexpr double kPriorReleaseGain = 4;
/// Half width of a 90 % interval of a normal distribution, in standard deviations. Statistics, not tuned.
inline constexpr double kInterval90 = 1.645;
/// Ratio of cost to expected cost. Up to here a model counts as right, and its intervals are not widened.
inline constexpr double kRightCostRatio = 1.15;
/// Samples at 16 ms whose errors are correlated where a model is wrong; widens intervals. From the specification
/// (N_eff = N / 8).
inline constexpr double kCorrelatedSamples = 8;
/// s. Period of those samples: errors of a log with other rows are correlated for as long.
inline constexpr double kCorrelatedPeriod = 0.016;
/// Share of a parameter: its 90 % interval is never narrower. A limit of 80 rad/s2 came back 0.3 % off from the logs of
/// another simulator.
inline constexpr double kFinestInterval = 0.004;
/// Share of a parameter's range. Closer to an end than this counts as at the bound.
inline constexpr double kBoundMargin = 1e-3;
/// Share of a parameter's range. Closer to neutral than this is not a finding: the encoder cannot resolve a delay, a
/// play or a gain that small.
inline constexpr double kNegligibleShare = 3e-4;
/// Noise floors that may remain after an effect that removes kExplainedGapShare of the gap.
inline constexpr double kRemainingFloors = 3;
/// Share of the gap that has to be removed where the misfit is still significant.
inline constexpr double kExplainedGapShare = 0.85;
/// Noise floors. A smaller gap without a named effect is `cannot_tell`, not `unknown`; a smaller remainder on held-out
/// logs takes no name away. From the specification.
inline constexpr double kLeastGapFloors = 2;

// ---- Bootstrap (gap/identify/bootstrap.cpp) ----

/// Simulated replicas of the logs: the 99th percentile needs about two hundred. From the specification.
inline constexpr int kBootstrapRuns = 200;
/// Replicas where the model is plainly wrong (kPlainCost): the threshold matters less there.
inline constexpr int kFewBootstrapRuns = 40;
/// Cost per residual above which a model, or a log of it (gap/identify/stuck_log.cpp), is plainly wrong; a right one
/// has about 1. It decides how many replicas are made, and whether a fit is tried from elsewhere, not what is named.
inline constexpr double kPlainCost = 1.5;
/// Seeds of replicas start here, apart from those of the noise model.
inline constexpr std::uint64_t kBootstrapSeed = 900'000'000;

// ---- Selection (gap/identify/selection.cpp, select.cpp, prune.cpp) ----

/// Times the chance gain that an effect has to gain where noise alone explains the residual.
inline constexpr double kChanceMargin = 1.3;
/// Least share of the cost beyond noise that an effect has to remove: any effect happens to remove some. From the
/// specification (5 % of the excess gap).
inline constexpr double kLeastExcessShare = 0.05;
/// Share of the cost beyond noise that an effect at its bound has to remove to be accepted.
inline constexpr double kBoundExcessShare = 0.8;
/// Cost per residual beyond noise. Above, a further effect must improve leave-one-out predictions.
inline constexpr double kCrossValidateCost = 2;
/// Prior standard deviations. With all other numbers fixed, a moved number is a finding beyond.
inline constexpr double kFixedNumberSigmas = 1.5;
/// Share of the cost beyond noise. If the first effect removed less, none that was tried alone may be right, and the
/// best pairs of effects that every servo can have are compared: of two that nearly cancel each other neither gains
/// anything alone. Friction of the wrong kind in the model: 3 and 3 % alone, 94 % together.
inline constexpr double kSaddleShare = 0.5;
/// Pairs that are fitted. A matter of run time.
inline constexpr std::size_t kFittedPairs = 3;
/// Effects that are looked for with all numbers fixed; more are a sign that the numbers are off. No evidence yet.
inline constexpr int kMaxEffectsFixed = 2;
/// Share of the gap. If two effects leave more, the selection stops, and its effects are not named: what has no name is
/// then the greater part. So it is on a roughly known motor: SO-101, Rotation, leaves 0.3 and names dry friction.
/// On the floor the held-out walk of another engine parts by itself: friction of 0.37, found as 0.33, leaves 0.47.
inline constexpr double kHopelessGapShare = 0.5;
/// A remaining gap below all three is a difference in how an effect is modelled, not a further effect: bootstrap
/// standard deviations, noise floors, share of the gap.
inline constexpr double kNearMisfitSigmas = 60, kNearFloors = 1.5, kNearGapShare = 0.15;
/// Ratio of position errors on held-out logs, after over before, above which the effects are withdrawn, and noise
/// floors by which it has to grow: what fresh noise alone does not reach.
inline constexpr double kHeldOutErrorRatio = 1.05, kHeldOutFloors = 1;
/// Times by which the error on held-out logs grows without any one of the effects, where those logs decide.
inline constexpr double kHeldOutHelp = 2;
/// Twice the log evidence within which a rival is not excluded: odds of 150 to 1; of 7 to 1 against a rival with more
/// free parameters. The scale of Kass and Raftery (1995).
inline constexpr double kRivalEvidence = 10, kLargerRivalEvidence = 4;

// ---- Shortlist of candidates (gap/identify/shortlist.cpp) ----

/// Effects whose starts are refined, by predicted gain; the second for a roughly known baseline. No evidence yet.
inline constexpr std::size_t kRefinedEffects = 10, kRefinedEffectsRough = 16;
/// Starts of each effect that are refined. From the specification (2 to 3).
inline constexpr std::size_t kStartsPerEffect = 3;
/// Effects that are fitted. From the specification (refine the best 5).
inline constexpr std::size_t kFittedEffects = 6;
/// Solver iterations of these fits, which only rank; the best are fitted again. No evidence yet.
inline constexpr int kShortlistIterations = 6;
/// Fitted models that are compared under the noise of the best.
inline constexpr std::size_t kComparedModels = 5;
/// Only models this close to the best are compared: share of its gain, or cost.
inline constexpr double kNearGainShare = 0.15, kNearCost = 60;
/// Prior cost. Above, the fit may have pulled the baseline numbers away, so it is repeated from their expected values.
inline constexpr double kPulledPriorCost = 15;
/// Twice the log evidence by which a rival must lead under the best model's noise to be refitted under its own.
inline constexpr double kRivalLead = 2;

// ---- Refit with matching noise (gap/identify/fitted_model.cpp) ----

/// Solver iterations of a fit under another model's noise, starting at its own. No evidence yet.
inline constexpr int kRefitIterations = 8;
/// Total cost. A round that gains less is the last.
inline constexpr double kRefitGain = 0.5;
/// Squared standard deviations. A fit that moved less keeps its noise model.
inline constexpr double kRefitMovement = 30;
/// Simulations per log behind a noise model. Fewer leave modes out, which then look like an effect; where the model
/// discrepancy counts as noise, fewer suffice.
inline constexpr int kNoiseRuns = 96, kDiscrepancyNoiseRuns = 24;

// ---- Cross-validation (gap/identify/cross_validation.cpp) ----

/// Solver iterations, starting at the fit to all logs.
inline constexpr int kCrossValidationIterations = 6;

// ---- Screen and refined starts (gap/identify/screen.cpp, refined_start.cpp, ripple_starts.cpp) ----

/// Periods per revolution up to which a torque ripple is looked for. From the catalogue's range.
inline constexpr int kMaxRipplesPerTurn = 60;
/// N m. Ripple whose response is linear: small against what moves an arm.
inline constexpr double kScreenRippleTorque = 0.004;
/// Gauss-Newton steps that refine a start. No evidence yet.
inline constexpr int kRefineIterations = 5;
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

/// Relative prior standard deviation of kt or resistance from which the motor counts as not measured.
inline constexpr double kRoughPrior = 0.1;
/// Cost. Least gain of an effect that every servo has: predictions improve from 2 on (Akaike 1974).
inline constexpr double kCommonEffectGain = 2;
/// Cost. Least gain of a rarer effect: with a dozen to choose from, one gains some by chance. No evidence yet.
inline constexpr double kRareEffectGain = 10;
/// Log ratio of prediction errors that a rarer effect has to exceed with 95 % confidence, and an effect whose interval
/// contains "no effect" in the mean: on the benches of tests/gap/identify/rough_selection_test.cpp a zero error that is
/// there reaches 0.15 on left-out logs, false ones 0.05. Of a servo with friction at rest and play, cogging, which it
/// does not have, reached 0.15 with a standard error of 0.05, on 28 logs.
inline constexpr double kRareEffectHelp = 0.1;
/// Fit logs from which on a third is searched for two effects before all are. A matter of run time: a third of twelve
/// has four.
inline constexpr std::size_t kLogsInThirds = 12;
/// Rarer effects per round that are cross-validated, where validation logs do not suffice. A matter of run time.
inline constexpr std::size_t kCrossValidatedEffects = 3;
/// Rarer effects that are added: a round takes half a minute. Of a folder with a speed profile and a delay, both are
/// found with two; with one, the remainder is 13 times the floor instead of 5.
inline constexpr int kMaxRareEffects = 3;

// ---- Noise model (gap/fit/noise.cpp, problem.cpp) ----

/// Samples on either side of a moving average. What varies faster is independent noise, what varies slower a mode.
inline constexpr int kNoiseHalfWindow = 3;
/// Samples on either side over which the variance of the independent part is averaged.
inline constexpr int kNoiseVarianceHalfWindow = 5;
/// Standard deviations of the independent part. Smaller modes are left out.
inline constexpr double kSmallestNoiseMode = 0.5;
/// s at the end of a released log in which a joint that is at rest moves by no more than the encoder resolves; half a
/// swing of an arm of 0.1 m is 0.3 s. No evidence yet.
inline constexpr double kRestTime = 0.3;
/// degC by which repeats may differ to count as one temperature: two steps of the register. No evidence yet.
inline constexpr double kSameTemperature = 2;
/// Standard deviations of the simulated rest beyond which repeats rest in different places. No evidence yet.
inline constexpr double kBifurcationSigmas = 6;
/// Factor on the spread of a few dozen runs, which underestimates that of many.
inline constexpr double kFewRunsFactor = 1.1;
/// Standard deviations beyond which a residual counts linearly (pseudo-Huber). The specification says 2.
inline constexpr double kRobustSigmas = 3;
/// Standard deviations of every sample of a hypothesis that cannot be simulated.
inline constexpr double kImpossibleSigmas = 1e3;

// ---- Model discrepancy (gap/fit/discrepancy.cpp) ----

/// s. Correlation time of a discrepancy: half a swing of an arm of 0.1 m.
inline constexpr double kDiscrepancyTime = 0.3;
/// Standard deviations beyond which a residual against a discrepancy counts linearly.
inline constexpr double kDiscrepancyRobustSigmas = 2;

// ---- Unknowns and steps (gap/fit/unknown.cpp, jacobian.cpp) ----

/// Prior standard deviations a search may move a baseline number by; beyond, an effect that says so explains it better.
inline constexpr double kFarthestPriorSigmas = 6;
/// Share of its expected value below which no search lowers a baseline number or a known parameter: they stay positive
/// where the prior is wide. No evidence yet.
inline constexpr double kLeastPriorShare = 0.2;
/// Share of a range below which a logarithmic parameter has no effect.
inline constexpr double kSmallestScale = 1e-4;
/// First difference step of an unknown: logarithmic ones by its logarithm; with a prior in its standard deviations;
/// else as a share of the range. The step of a refined search comes from the information matrix. No evidence yet.
inline constexpr double kFirstLogStep = 0.02, kFirstStepSigmas = 0.2, kFirstStepShare = 0.003;
/// First steps. Longest and shortest difference step: a shorter one meets the roughness of stick and slip. No evidence
/// yet.
inline constexpr double kLongestStep = 2, kShortestStep = 1e-6;
/// Share of a step. Less room to a bound on either side counts as this much.
inline constexpr double kLeastStepRoom = 0.01;

// ---- Least squares (gap/fit/levenberg.cpp, solve.cpp) ----

/// Relative cost. A solver step that gains less is the last.
inline constexpr double kSolverTolerance = 1e-5;
/// Solver iterations of a search, unless its caller wants fewer. No evidence yet.
inline constexpr int kSolverIterations = 12;
/// Standard deviations beyond which a residual counts linearly while the search is far off.
inline constexpr double kFarRobustSigmas = 100;
/// Cost per residual above which a search counts as far off; a right model has about 1.
inline constexpr double kFarCost = 2.5;
/// Share of the largest eigenvalue below which the data do not determine a direction.
inline constexpr double kUnobservableEigenvalue = 1e-9;
/// Squared component of an unknown in such directions from which it counts as not determined. No evidence yet.
inline constexpr double kUnobservableShare = 0.01;
/// Cost, and share of the cost, that a jump out of a local minimum has to gain; jumps per search. No evidence yet.
inline constexpr double kJumpGain = 2, kJumpGainShare = 0.005;
inline constexpr int kMaxJumps = 3;
/// Jumps that are tried, in difference steps: along each unknown, and along the eigenvectors of a refined search. No
/// evidence yet.
inline constexpr std::array<double, 6> kFirstJumps{-10, -3, -1, 1, 3, 10}, kRefinedJumps{-4, -2, -1, 1, 2, 4};

// ---- Block tests (gap/localize/block_test.cpp, blocks.cpp, absorb.cpp, fit_nuisances.cpp) ----

/// Standard deviations beyond simulated repeats from which a block is open.
inline constexpr double kOpenSigmas = 6;
/// Standard deviations that the baseline numbers may move for a block to close: exceeded once in 2000.
inline constexpr double kMovedSigmas = 3.3;
/// Samples on either side over which the spread of the simulated repeats is averaged.
inline constexpr int kRepeatsHalfWindow = 3;
/// s. Length of the boxes of which the worst is tested.
inline constexpr double kBlockBox = 0.25;
/// Least relative spread of the mean cost over all logs, of the worst log and of the worst box: eight repeats estimate
/// a spread badly, and no two simulators agree exactly.
inline constexpr double kSpreadOfAll = 0.07, kSpreadOfLog = 0.1, kSpreadOfWorst = 0.2;
/// Prior standard deviations that absorption may move a number by; a larger move is itself a finding.
inline constexpr double kAbsorbedSigmas = 3;
/// Reweightings in absorption.
inline constexpr int kAbsorptionRounds = 12;
/// Gauss-Newton steps that fit the baseline numbers to a block, and prior standard deviations of a difference step.
inline constexpr int kNuisanceSteps = 3;
inline constexpr double kNuisanceStepSigmas = 0.5;
/// s. Window of law speed_p in which the positions show what the law commanded.
inline constexpr double kSpeedLawWindow = 0.06;
/// Share of the plant's cost beyond noise that a delay has to explain for the plant to count as closed.
inline constexpr double kDelayShare = 0.75;
/// Times the expected rms that a speed register must exceed: servos filter their speed in many ways.
inline constexpr double kSensorRatio = 1.5;
/// Times the expected rms up to which an open controller that nothing explains counts as closed, and the share of its
/// cost that counts as an explanation.
inline constexpr double kControllerNoiseRatio = 1.2, kControllerExplainedShare = 0.15;
/// Share of the plant's cost that may remain with what was found in earlier blocks.
inline constexpr double kPlantRemainderShare = 0.1;

// ---- Command or controller (gap/localize/command_split.cpp) ----

/// s since the goal moved after which a profile has arrived.
inline constexpr double kGoalAtRest = 0.5;
/// Shares of the cost beyond noise: less explains nothing; more explains all; of the mean, less at
/// rest is none. No evidence yet.
inline constexpr double kSplitExplains = 0.15, kSplitExplainsAll = 0.9, kSplitRestIsNone = 0.1;

// ---- Intervals, regions, remainder (gap/localize/intervals.cpp, interval_scan.cpp, regions.cpp, remains.cpp) ----
//
// No verdict depends on them: they choose what a report lists, and its words.

/// False discovery rate of intervals (Benjamini and Hochberg 1995). From the specification.
inline constexpr double kFalseDiscoveries = 0.01;
/// Share of samples that counts as independent: a release leaves correlated errors.
inline constexpr double kIndependentShare = 0.5;
/// Intervals that are listed, and those of loads and voltages among them.
inline constexpr std::size_t kMostIntervals = 10, kMostBlockIntervals = 4;
/// Share of the greatest duty that counts as all of it. Shares of an interval's rows without torque and at full duty
/// from which the interval is named after that. No evidence yet.
inline constexpr double kFullDutyShare = 0.99, kLimpShare = 0.5, kSaturatedShare = 0.3;
/// rad from row to row that is a step of the goal; s that it lasts on; rad/s of rest and of slow motion.
inline constexpr double kGoalStep = 0.1, kAfterGoalStep = 0.3, kRestSpeed = 0.05, kSlowSpeed = 0.3;
/// Bins of a state variable and of the residual; samples in a bin that is named.
inline constexpr std::size_t kStateBins = 8, kResidualLevels = 4, kFewestInBin = 12;
/// Share of the variance below which state or clock explain nothing.
inline constexpr double kDependenceShare = 0.05;
/// rad/s above which a direction of motion is known.
inline constexpr double kDirectionSpeed = 0.05;
/// bits below which a state variable is not worth naming.
inline constexpr double kInformativeBits = 0.05;
/// Share of the energy in one interval that makes it an event. From the specification.
inline constexpr double kEventShare = 0.8;
/// Ratio of energy in a bin to the mean from which the bin is named.
inline constexpr double kLiftedBin = 1.5;

// ---- Whole robot (gap/localize/body, gap/identify/body) ----

/// s. Length of the stretch that a row of the table names. No verdict depends on it.
inline constexpr double kWorstStretch = 0.5;
/// Prior standard deviations of the deviations of an inertial sensor: rad/s, m/s2, share, rad. What data sheets allow
/// for bias and scale, and an assembly for the mounting; half or twice of it moves twice the log evidence by at
/// most 1.4 for each number.
inline constexpr double kGyroBias = 0.2, kAccelBias = 0.5, kAccelScale = 0.1, kImuRotation = 0.1;
/// Simulations of a limb behind its noise model, and the variance of the slow part, as a share of the fast one, from
/// which it is a mode: a mean of seven independent samples has 0.14, twelve runs scatter by 0.4 of that. No evidence
/// yet.
inline constexpr int kLimbNoiseRuns = 12;
inline constexpr double kSlowNoiseShare = 0.4;
/// Factor on these modes: where a released arm comes to rest depends on how a simulator lets dry friction stick. At 1.1
/// the arms of another simulator's robots diverged by some 3 sigma. No evidence for 3 against 2.
inline constexpr double kReleasedFactor = 3;
/// rad from a mechanical stop where a limp joint has met it, and by which it has then been moved away; s after which a
/// servo has caught a limb again. An arm that fell on its stop lay 10 mrad off in another simulator, and 3 mrad off in
/// its own exact model for as long as it was held there: both looked like an offset of its encoder.
inline constexpr double kStopMargin = 0.05, kCaught = 0.3;
/// Prior standard deviations of a difference step of a limb's numbers (and of the gain, which is nearly linear): where
/// dry friction holds a joint or not, a slope over a whole one leads nowhere. With 1, three steps and all logs at once,
/// 5 of 8 robots of the own suite (effect-free, numbers wrong, seed 2026) were not like their model; with these, none.
inline constexpr double kPriorStep = 0.2;
/// Steps of Gauss and Newton towards the most probable numbers of a limb, and the least share of one that is tried. A
/// matter of run time: most limbs close in two.
inline constexpr int kNumberSteps = 12;
inline constexpr double kLeastShareOfAStep = 1.0 / 32;
/// Duty. Noise of measured load minus control law, whatever the register resolves: a position that is wrong by a tick.
inline constexpr double kLawResidual = 0.002;
/// Limbs with an open row from which an effect of all joints is looked for: two are a pair.
inline constexpr std::size_t kLimbsOfAll = 3;
/// Chance that the best of all names of a robot's mechanics earns its place in recordings of a right model.
inline constexpr double kMechanicalChance = 0.01;
/// Candidates of the linear screen that are fitted, and those of each limb in any case; solver iterations; candidates
/// of a limb, or of the floor, that may fail a log or the held-out ones. A matter of run time.
inline constexpr std::size_t kFittedMechanics = 8, kFittedOfLimb = 3, kRefusedOfLimb = 2;
inline constexpr int kMechanicsIterations = 8;
/// Scales of a fitted effect at which other local minima are looked for, and rounds. The cost of a play of 6.4 mrad in
/// all joints had local minima at 4.2, 5.6 and 5.8 mrad (robot of tests/gap/body/moving_robot.hpp).
inline constexpr double kMechanicsStrengths[] = {0.6, 0.8, 0.9, 1.1, 1.25, 1.6};
inline constexpr int kMechanicsValleys = 3;
/// Torque ripples a turn from which they are looked for in a robot's joint, which moves by a sixth of a turn: fewer
/// look like any torque that changes with the angle. Counts of a joint, a pair or all that are simulated. No evidence
/// yet.
inline constexpr int kFewestRipples = 8;
inline constexpr std::size_t kScreenedRipples = 2;
/// Share of what is beyond noise in its limbs that an effect has to explain to be added: less is a patch on another
/// effect. No evidence yet.
inline constexpr double kMechanicsShare = 0.1;
/// The same, of what was beyond noise before the first effect: a large effect that is modelled nearly right leaves a
/// little, after a release above all. A friction that moved an arm by 0.2 rad left 7e-5.
inline constexpr double kMechanicsRemainder = 0.002;
/// Squared change of a log's residuals, in sigmas, from which the log may refute an effect by losing half of it: a
/// right one would gain all of it, with a standard deviation of twice its root, so that it loses half by chance in
/// 1e-4. Multiplied by LogGain::remainder(). A link of -0.01 kg that chaos of one release suggested in
/// another physics lost 0.6 and 0.8 of 40 in two other logs; the effects of the example cases gain in every log.
inline constexpr double kDecidingChange = 25;
/// Ratio of held-out errors from which an effect of the mechanics worsens them and is dropped: repeats differ by 1 %.
inline constexpr double kHeldOutRise = 1.03;
/// Simulated repeats behind the noise that the held-out gap of a robot is compared with. Of an effect-free example
/// case, 4 seeds, joints: one repeat 0.72 to 0.83 mrad, two 0.72 to 0.77, eight 0.72.
inline constexpr std::size_t kHeldOutRepeats = 2;
/// Held-out error of the joints in an effect's limbs, in noises of a reading, up to which a remainder takes no name
/// away that the held-out logs show. From the specification.
inline constexpr double kSmallRemainder = 2;
/// Rivals of a mass or centre of mass that are listed, the most probable ones: a set of three. From the specification.
inline constexpr std::size_t kMostLinkRivals = 2;
/// Effects of the mechanics that are looked for. From the specification (two, and a spare).
inline constexpr std::size_t kMostMechanics = 3;

/// V. Noise of a supply whatever its register resolves: that of Disturbance. No evidence from a robot yet.
inline constexpr double kSupplyNoise = 0.03;

// ---- Robot on the floor (gap/localize/body/floor_noise.cpp, gap/identify/body/floor_selection.cpp) ----

/// Simulated repeats behind the noise of a robot on the floor, and draws of all uncertain numbers: half a second each.
/// What these few do not span is added to the noise of each sample.
inline constexpr int kFloorNoiseRuns = 8;
inline constexpr std::size_t kFloorPriorRuns = 24;
/// Factor on the draws: a few underestimate the spread of many. No evidence yet.
inline constexpr double kFewDrawsFactor = 1.5;
/// By what engines differ that solve the same contacts: factor on the distance of the impedance from 1; m by which
/// the robot is put down; relative changes of contact time and friction. No evidence yet.
inline constexpr double kEngineImpedance = 3, kEngineDrop = 0.001, kEngineContactTime = 0.3, kEngineFriction = 0.1;
/// Share of the contact time by which an impact's peak may be earlier or later in another engine: an impact lasts about
/// as long. With nothing hidden, accelerometers of walks of an engine with springs for contacts were 9 to 10 sigma off
/// without it.
inline constexpr double kEngineTiming = 0.5;
/// Prior standard deviation of the scale of a gyroscope.
inline constexpr double kGyroScale = 0.2;
/// Effects of the floor that are fitted after the screen; solver iterations of those whose cost beyond noise at their
/// start, and then after the fit, is not so many times that of the best; relative cost of the last iteration; effects
/// that are looked for. A matter of run time.
inline constexpr std::size_t kFittedFloor = 3;
inline constexpr int kFloorRivalIterations = 2, kFloorIterations = 5;
inline constexpr double kFloorStartFarBehind = 10, kFloorFarBehind = 3;
inline constexpr double kFloorTolerance = 1e-3;
inline constexpr std::size_t kMostFloorEffects = 2;
/// Share of a log's squared residuals that a linear effect explains in it alone: the fit also begins there. A tilt of
/// 0.039 rad was fitted as 0.018 from the solution for all logs, of which the walk is not linear (--effect floor_tilt,
/// seed 412).
inline constexpr double kFloorStartShare = 0.5;
/// Strengths of a fitted effect from which the search goes on if one is better, and how often. A trunk's centre of mass
/// that was off by 18 mm stopped at 16.4 without them.
inline constexpr std::array kFloorStrengths{0.8, 0.9, 1.1, 1.2};
inline constexpr int kFloorValleys = 3;
/// Strengths from which what was found is fitted once more, under its own noise. A trunk's centre of mass (example x05)
/// ended in valleys up to 2.4 mm apart, none better than another; four strengths instead of two found no better one.
inline constexpr std::array kFloorSides{0.9, 1.1};
/// By which share the costs of models differ that are as good: chaos. 80 centres of mass around that of x05 lay 6 %
/// beside a smooth surface, in its walk alone 11 %.
inline constexpr double kFloorChaos = 0.1;
/// Share of what is beyond noise on the floor that an effect has to explain: the greater part. Up to 34 % was explained
/// by centres of mass and frictions of robots with another contact time (--effect contact_time, seeds 301 and 303); 74
/// to 99 % by right tilts, soles, frictions and trunks of the same engine (seeds 411 to 415, 422 to 424).
inline constexpr double kFloorShare = 0.5;
/// Cost of a sample of a right model: engines that differ widen the noise. A right model of the example cases had 0.43.
inline constexpr double kFloorCostOfNoise = 0.5;

// ---- Gyroscope against the kinematics of a stance foot (gap/identify/body/stance_gyro.cpp) ----
//
// From robots of two physics engines without an effect of the gyroscope, contacts of several kinds among them.

/// rad/s. What a foot that stands turns by, and what the encoders add; on top of the sensor's own noise.
inline constexpr double kStanceNoise = 0.042;
/// rad/s. What it gives way by about its forward axis: with 0.11, soft floors looked like a scale of 1.17 to 1.3.
inline constexpr double kStanceRoll = 0.3;
/// rad/s. Rates of a foot that rolls or tips on an edge, or swings.
inline constexpr double kStanceRocking = 1;
/// Chance that a foot is in the next row in the same contact: contacts of a walk last some 0.1 s.
inline constexpr double kStanceStay = 0.85;
/// Rows that count as one: a foot gives way slowly. Rates of robots without an effect gained up to 10 in log
/// likelihood by a scale of one axis; those with a scale of 0.86 or 0.79 gained 74 and more.
inline constexpr double kStanceCorrelated = 3;
/// s. Delays that count as none: without an effect, the likelihood had its maximum at -4 to 4 ms, 19 above that at 0.
inline constexpr std::array kStanceTiming{-0.004, -0.002, 0.002, 0.004};
/// Share of the log likelihood gained in a row of logs for fits that a row of held-out logs has to gain. No evidence
/// yet.
inline constexpr double kStanceHeldOut = 0.1;

// ---- Simulation and block residuals (gap/plant) ----

/// s. Rows on either side from which a speed is computed: a parabola through five rows of 16 ms. No evidence yet.
inline constexpr double kStateHalfWindow = 0.04;
/// s. A faster firmware is simulated as one of this period that looks ahead: one of 0.1 ms costs ten times one of 1 ms,
/// and hardly differs.
inline constexpr double kLongestFold = 5e-4;
/// Change of the load in such a period from which the duty has jumped: no motion changes it as fast. No evidence yet.
inline constexpr double kFoldedLoadJump = 0.05;
/// s, and share of the speed, by which servo families differ in how they compute the speed that they report. No
/// evidence yet.
inline constexpr double kSpeedLag = 0.012, kSpeedScale = 0.05;

// ---- Words of a report (gap/report). No verdict depends on them. ----

/// Share of the noise. A held-out error below it is flagged: the noise is less than assumed, or the log is not
/// independent of the model. No evidence yet.
inline constexpr double kBelowFloorShare = 0.7;
/// Share of a gap that counts as unchanged. No evidence yet.
inline constexpr double kUnchangedGapShare = 0.02;

}  // namespace darwinop::gap::thresholds
