// The experiment that the catalogue recommends ranks above one that cannot distinguish.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gap/plan/plan_rig.hpp"
#include "gap/plan/thresholds.hpp"

namespace darwinop::gap {
namespace {

NextExperiments rankedFor(const FittedHypothesis& a, const FittedHypothesis& b, const std::vector<std::string>& names) {
  std::vector<ExperimentCandidate> candidates;
  for (const std::string& name : names) candidates.push_back(named(name));
  return nextExperiments(smallBench(), armSetupFor(Joint::kShoulderR), {Aim::kSeparate, {a, b}, 0}, candidates,
                         kFewRuns);
}

double sigmaFor(const NextExperiments& next, const std::string& name) {
  for (const Ranked& ranked : next.ranked)
    if (ranked.vetted.candidate.experiment.name == name) return ranked.separations.at(0).sigma;
  return -1;
}

// From below the arm stops short for either reason; from both sides the reasons differ.
TEST(Ranking, HoldsFromBothSidesDistinguishDryFrictionFromAMass) {
  const Case bench = smallBench();
  const NextExperiments next =
      rankedFor(hypothesisWith(bench, "coulomb", "friction", 0.04, 1.0),
                hypothesisWith(bench, "com_mass", "mass", 0.1, 0.1), {"hold_once", "hold_from_both_sides"});
  EXPECT_THAT(namesOf(next), testing::ElementsAre("hold_from_both_sides", "hold_once"));
  EXPECT_GT(sigmaFor(next, "hold_from_both_sides"), 3);
}

// Play shows where gravity changes sides; on one side it is always shut.
TEST(Ranking, MotionAroundHangingDistinguishesADeadBandFromPlay) {
  const Case bench = smallBench();
  const NextExperiments next =
      rankedFor(hypothesisWith(bench, "deadband", "width", 0.006, 0.5),
                hypothesisWith(bench, "backlash", "play", 0.012, 0.5), {"hold_once", "small_sines"});
  EXPECT_THAT(namesOf(next), testing::ElementsAre("small_sines", "hold_once"));
  EXPECT_GT(sigmaFor(next, "small_sines"), 3);
}

// Back EMF brakes with the bridge on only.
TEST(Ranking, ASwingWithoutTorqueDistinguishesAWrongMotorFromViscousFriction) {
  const Case bench = smallBench();
  const NextExperiments next = rankedFor(hypothesisWith(bench, "kt_error", "change", 0.05, 0.05),
                                         hypothesisWith(bench, "viscous", "damping", 0.03, 0.7),
                                         {"hold_once", "constant_speed", "swing_three_heights"});
  EXPECT_EQ(namesOf(next).at(0), "swing_three_heights");
  EXPECT_EQ(namesOf(next).at(2), "hold_once");
}

// 19 and 700 sigma in 14 and 35 s.
TEST(Ranking, TheShorterOfTwoThatSurelySeparateIsFirst) {
  const Case bench = smallBench();
  const NextExperiments next =
      rankedFor(hypothesisWith(bench, "coulomb", "friction", 0.06, 0.01),
                hypothesisWith(bench, "encoder_offset", "offset", 0.05, 0.01), {"swing_three_heights", "hold_once"});
  EXPECT_THAT(namesOf(next), testing::ElementsAre("hold_once", "swing_three_heights"));
  EXPECT_GT(sigmaFor(next, "hold_once"), thresholds::kSurelySeparated);
}

TEST(Ranking, WhatARefitAbsorbsSeparatesNothing) {
  const Case bench = smallBench();
  const FittedHypothesis friction = hypothesisWith(bench, "coulomb", "friction", 0.04, 1e-3);
  FittedHypothesis other = hypothesisWith(bench, "coulomb", "friction", 0.042, 1e-3);
  const double separated = sigmaFor(rankedFor(friction, other, {"hold_from_both_sides"}), "hold_from_both_sides");
  other = hypothesisWith(bench, "coulomb", "friction", 0.042, 0.5);
  const double absorbed = sigmaFor(rankedFor(friction, other, {"hold_from_both_sides"}), "hold_from_both_sides");
  EXPECT_LT(absorbed, 0.2 * separated);
  EXPECT_LT(absorbed, 1);
}

TEST(Ranking, WhatBothModelsMissOfTheServoSeparatesNothing) {
  const Case bench = smallBench();
  FittedHypothesis friction = hypothesisWith(bench, "coulomb", "friction", 0.04, 1e-3);
  FittedHypothesis other = hypothesisWith(bench, "coulomb", "friction", 0.042, 1e-3);
  const auto separated = [&] {
    return sigmaFor(rankedFor(friction, other, {"hold_from_both_sides"}), "hold_from_both_sides");
  };
  const double by_noise_alone = separated();
  for (FittedHypothesis* const one : {&friction, &other})
    one->discrepancy = {.position_rad = 0.02, .load = {0.1}, .correlation_s = 0.2};
  EXPECT_LT(separated(), 0.2 * by_noise_alone);
}

TEST(Ranking, TheSameRoundTwiceGainsNoMorePerMinute) {
  const Case bench = smallBench();
  ExperimentCandidate once = named("hold_once"), twice = once;
  twice.experiment.rounds.push_back(twice.experiment.rounds.front());
  const NextExperiments next = nextExperiments(
      bench, armSetupFor(Joint::kShoulderR),
      {Aim::kSeparate,
       {hypothesisWith(bench, "coulomb", "friction", 0.05, 0.1), hypothesisWith(bench, "com_mass", "mass", 0.2, 0.01)},
       0},
      {twice, once}, kFewRuns);
  ASSERT_EQ(next.ranked.size(), 2U);
  EXPECT_EQ(next.ranked[0].vetted.candidate.experiment.rounds.size(), 1U);
  EXPECT_EQ(next.ranked[0].separations[0].sigma, next.ranked[1].separations[0].sigma);
  EXPECT_GT(next.ranked[0].perMinute(), next.ranked[1].perMinute());
}

TEST(Ranking, NarrowsTheIntervalOfAFrictionByMovingNotByWaiting) {
  const Case bench = smallBench();
  const Question question{Aim::kNarrow, {hypothesisWith(bench, "coulomb", "friction", 0.04, 0.5)}, 2};
  const NextExperiments next = nextExperiments(bench, armSetupFor(Joint::kShoulderR), question,
                                               {named("hold_once"), named("hold_from_both_sides")}, kFewRuns);
  EXPECT_EQ(namesOf(next).at(0), "hold_from_both_sides");
  EXPECT_LT(next.ranked[0].sigma_after, 0.3 * next.ranked[0].sigma_before);
  EXPECT_THAT(sentenceOf(next.question, next.ranked[0]), testing::HasSubstr("narrows coulomb.friction from"));
}

TEST(Ranking, HasAOneSentenceSummary) {
  Ranked ranked;
  ranked.vetted.candidate = named("small_sines");
  ranked.vetted.seconds = 20;
  ranked.separations = {{0, 1, 14.2}};
  const Case bench = smallBench();
  const Question question{
      Aim::kSeparate,
      {hypothesisWith(bench, "backlash", "play", 0.01, 1), hypothesisWith(bench, "deadband", "width", 0.01, 1)},
      0};
  const std::string sentence = sentenceOf(question, ranked);
  for (const char* const part : {"small_sines: ", "backlash", "deadband", "14 sigma", "20 s"})
    EXPECT_THAT(sentence, testing::HasSubstr(part));
}

TEST(Plan, HasOneExperimentForEachPairWithItsTime) {
  const Case bench = smallBench();
  const auto ranked = [](const char* name, double seconds, std::vector<Separation> separations) {
    Ranked one;
    one.vetted.candidate = named(name);
    one.vetted.seconds = seconds;
    one.separations = std::move(separations);
    return one;
  };
  NextExperiments next{
      {Aim::kSeparate,
       {hypothesisWith(bench, "backlash", "play", 0.01, 1), hypothesisWith(bench, "deadband", "width", 0.01, 1),
        hypothesisWith(bench, "coulomb", "friction", 0.01, 1)},
       0},
      armSetupFor(Joint::kShoulderR),
      {},
      {}};
  next.ranked.push_back(ranked("small_sines", 20, {{0, 1, 14}, {0, 2, 0.2}, {1, 2, 0.3}}));
  next.ranked.push_back(ranked("hold_once", 31, {{0, 1, 40}, {0, 2, 2}, {1, 2, 0.1}}));
  next.ranked.push_back(ranked("hold_from_both_sides", 47, {{0, 1, 9}, {0, 2, 7}, {1, 2, 0.5}}));
  const std::vector<Decision> decisions = decisionsOf(next);
  ASSERT_EQ(decisions.size(), 2U) << "nothing separates the third pair";
  EXPECT_EQ(decisions[0].by, &next.ranked[0]) << "enough, in less time";
  EXPECT_EQ(decisions[1].by, &next.ranked[2]) << "the one before is not enough";
  const std::string text = asText(next);
  for (const char* const part : {"small_sines, 20 s", "hold_from_both_sides, 47 s", "backlash or deadband"})
    EXPECT_THAT(text, testing::HasSubstr(part));
  next.question.aim = Aim::kNarrow;
  EXPECT_TRUE(decisionsOf(next).empty());
}

}  // namespace
}  // namespace darwinop::gap
