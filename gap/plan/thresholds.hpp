// Tuned constants of planning, each with its unit and the evidence for its value. No verdict depends on them: they
// choose which experiments a plan lists first, and its words. "No evidence yet": chosen by judgement.
#pragma once

#include <cstddef>

namespace darwinop::gap::thresholds {

// ---- Which hypotheses (gap/plan/question.cpp). A rival is one that is not excluded: kRivalEvidence. ----

/// Rivals that are compared: each costs simulations against every other. A matter of run time.
inline constexpr std::size_t kMostPlannedRivals = 3;
/// Share of an effect that the baseline already has by which a larger one is assumed. No evidence yet.
inline constexpr double kMoreOfAnEffect = 0.3;
/// Solver iterations for each effect of a hypothesis. No evidence yet.
inline constexpr int kPlannedFitIterations = 8;

// ---- What an experiment would show (gap/plan/prediction.cpp, ranking.cpp) ----

/// Share of a range. Longest difference step of a prediction, which is linear. No evidence yet.
inline constexpr double kLongestPredictionStep = 0.1;
/// Share of the first step of a fit (Unknown::firstStep()). Shortest difference step of a prediction. No evidence yet.
inline constexpr double kShortestPredictionStep = 0.2;
/// Reweightings of large residuals. They converge in three or four.
inline constexpr int kPredictionReweightings = 6;
/// Standard deviations between two rivals from which an experiment decides, also if the bench is three times as noisy
/// as the model: more adds nothing to its rank, so that the shorter of two such experiments comes first. Judgement.
inline constexpr double kSurelySeparated = 10;
/// Standard deviations from which an effect is certain to show: more adds nothing to an experiment's rank. A chance of
/// 6e-7; no evidence yet for the rank.
inline constexpr double kCertainToShow = 5;

// ---- Its words (gap/plan/ranking_text.cpp) ----

/// Standard deviations from which an effect is listed as shown, and below which an experiment is listed as
/// uninformative. The usual ones of statistics, not tuned.
inline constexpr double kListedAsShown = 3, kUninformative = 1;
/// Standard deviations beyond which a linear prediction is printed as "more than". No evidence yet.
inline constexpr double kMostPrintedSigmas = 100;

// ---- Safety of the robot (gap/plan/safety_check.cpp, arm_setup.cpp): margins, chosen and not tuned ----

/// rad beyond the limits of goals that a predicted motion may reach: the mechanical stops are behind that.
inline constexpr double kAllowedOvershoot = 0.05;
/// Share of the time at full duty after which the servo switches itself off.
inline constexpr double kAllowedOverloadShare = 0.5;
/// rad between the first pose and a limit of goals: an upper arm hangs beyond its limit.
inline constexpr double kStartMargin = 0.03;
/// s. A round that would have to be shorter is left out, as is one that is still unsafe after this many attempts.
inline constexpr double kShortestRound = 1;
inline constexpr int kSafetyAttempts = 3;

}  // namespace darwinop::gap::thresholds
