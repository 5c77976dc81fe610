// A harmful experiment is refused or shortened, with the reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/format/plan.hpp"
#include "gap/plan/commands.hpp"
#include "gap/plan/messages.hpp"
#include "gap/plan/plan_rig.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Vetted vettedOn(const std::string& name, Joint joint, double payload_kg = 0.3) {
  const Case bench = smallBench();
  const ArmSetup stand = armSetupFor(joint);
  ExperimentCandidate candidate = named(name, stand);
  candidate.payload_kg = payload_kg;
  return vetted(std::move(candidate), stand, bench, {baselineOf(bench)});
}

TEST(Vetting, LetsTheRobotsArmDoAllOfThem) {
  const Case bench = smallBench();
  const ArmSetup stand = armSetupFor(Joint::kShoulderR);
  for (const experiments::Experiment& experiment : benchExperiments(stand)) {
    const Vetted one = vetted({.experiment = experiment, .payload_kg = 0.2, .prepare = {}, .prepare_s = 0}, stand,
                              bench, {baselineOf(bench)});
    EXPECT_EQ(one.refused, "") << experiment.name;
    EXPECT_THAT(one.cuts, testing::IsEmpty()) << experiment.name;
    EXPECT_GT(one.seconds, 5) << experiment.name;
  }
}

TEST(Candidates, HaveTheMiddleGainOfTheLogsAndAThirdMoreToLift) {
  Case bench = smallBench();
  ASSERT_GE(bench.logs.size(), 3U);
  bench.logs.resize(3);
  const double registers[] = {100, 200, 400};
  for (std::size_t i = 0; i < 3; ++i)
    bench.logs[i].held_out = false, bench.logs[i].p_register = registers[i], bench.logs[i].payload_kg = 3;
  double heavier_kg = 0;
  for (const ExperimentCandidate& one : benchCandidates(bench, armSetupFor(Joint::kShoulderR))) {
    const double p_gain = one.experiment.rounds.front().phases.front().p_gain;
    if (one.experiment.name == "long_steps") {
      EXPECT_EQ(p_gain, 25);
    }
    if (one.experiment.name == "long_steps_heavier") heavier_kg = one.payload_kg;
  }
  EXPECT_NEAR(heavier_kg, 3.9, 1e-9);
}

TEST(Vetting, RefusesAGainThatNoExperimentHas) {
  ExperimentCandidate candidate = named("long_steps");
  candidate.experiment.rounds.front().phases.front().p_gain = 100;
  const Case bench = smallBench();
  const ArmSetup stand = armSetupFor(Joint::kShoulderR);
  EXPECT_THAT(vetted(std::move(candidate), stand, bench, {baselineOf(bench)}).refused,
              HasSubstr(messages::kGainBeyondFormat));
}

TEST(Vetting, RefusesAGoalBeyondTheJointsLimits) {
  EXPECT_THAT(vettedOn("holds_both_sides", Joint::kPelvR).refused,
              HasSubstr("would send PelvR to -1.5 rad; its limits"));
}

// The goals are within the limits; the end of a limp swing needs the simulation.
TEST(Vetting, LeavesOutTheSwingsThatEndInTheStops) {
  const Vetted one = vettedOn("swing_three_heights", Joint::kLegUpperL);
  EXPECT_EQ(one.refused, "");
  EXPECT_EQ(one.candidate.experiment.rounds.size(), 1U) << "the lowest";
  EXPECT_THAT(one.cuts, ElementsAre(HasSubstr("LegUpperL would get to -0.5"), HasSubstr("LegUpperL would get to")));
}

TEST(Vetting, RefusesWhatHasNoSafeRound) {
  const ArmSetup stand = armSetupFor(Joint::kLegUpperL);
  ExperimentCandidate candidate = named("swing_three_heights", stand);
  candidate.experiment.rounds.erase(candidate.experiment.rounds.begin());
  const Case bench = smallBench();
  EXPECT_THAT(vetted(std::move(candidate), stand, bench, {baselineOf(bench)}).refused,
              HasSubstr("its limits are -0.497 to 1.68"));
}

TEST(Vetting, ShortensAHoldAtFullDuty) {
  constexpr double kTooHeavy = 4;  // kg: more than the 2.5 N m that the servo has
  const Vetted one = vettedOn("hold_long", Joint::kShoulderR, kTooHeavy);
  ASSERT_THAT(one.cuts, ElementsAre(HasSubstr("the servo would run at full duty for more than 1 s")));
  const auto& phases = one.candidate.experiment.rounds.at(0).phases;
  double seconds = 0;
  for (const auto& phase : phases) seconds += phase.duration_s;
  EXPECT_LT(seconds, 3);
  EXPECT_NO_THROW((void)experiments::makePlan(one.candidate.experiment, safety::hardRanges()));
}

TEST(Vetting, ChecksEveryHypothesis) {
  const Case bench = smallBench();
  const ArmSetup stand = armSetupFor(Joint::kShoulderR);
  ExperimentCandidate candidate = named("hold_long", stand);
  candidate.payload_kg = 2.2;
  EXPECT_THAT(vetted(candidate, stand, bench, {baselineOf(bench)}).cuts, testing::IsEmpty());
  const Hypothesis heavier = withEffect(bench, "com_mass", "mass", 0.4);
  EXPECT_THAT(vetted(candidate, stand, bench, {baselineOf(bench), heavier}).cuts, testing::SizeIs(1));
}

}  // namespace
}  // namespace darwinop::gap
