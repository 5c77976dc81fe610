// Planning: ranges, speeds, durations and limits are checked before a run.
#include "experiments/format/plan.hpp"

#include <gmock/gmock.h>

#include "experiments/format/messages.hpp"
#include "experiments/format/texts.hpp"

namespace darwinop::experiments {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kStep = "goal = step\nto = 30 deg\nvelocity = 2 rad/s\n";

std::string phaseText(const std::string& lines) {
  return with(kNod, kStep, lines);
}

Plan planOf(const std::string& text) {
  static Experiment experiment;  // must outlive the plan
  experiment = parseExperiment(text, "my.ini");
  return makePlan(experiment, safety::hardRanges());
}

TEST(Plan, ContainsRangesAndSpeeds) {
  const Plan plan = planOf(phaseText("goal = move\nto = 30 deg\n"));
  ASSERT_EQ(plan.moved.size(), 1U);
  EXPECT_NEAR(plan.moved[0].low, 0.00307, 1e-5) << "the start pose: tick 2050";
  EXPECT_NEAR(plan.moved[0].high, 0.5236, 1e-4);
  EXPECT_NEAR(plan.moved[0].fastest, 1.875 * 0.5205, 0.01) << "sampled every 4 ms of 1 s";
  EXPECT_FALSE(plan.on_feet);
  // 1 s there, 1 s, and back: 0.52 rad at 0.6 rad/s at most, then 1 s.
  EXPECT_NEAR(plan.seconds(), 3 + 1.875 * 0.5205 / 0.6, 0.01);
}

TEST(Plan, GoalBeyondTheLimitIsRefusedWithBoth) {
  EXPECT_THAT(
      refusal(with(kNod, "30 deg", "1.7 rad")),
      AllOf(StartsWith("my.ini, line 10: [phase turn] would send Neck to 1.7 rad"), HasSubstr("-1.93 to 1.69")));
  EXPECT_EQ(refusal(with(kNod, "30 deg", "1.69 rad")), "");
}

TEST(Plan, ChecksTheWholeTrajectory) {
  EXPECT_THAT(refusal(phaseText("goal = sine\namplitude = 1.75 rad\nfrequency = 1 Hz\n")),
              HasSubstr("would send Neck to 1.7"));
  EXPECT_THAT(refusal(phaseText("goal = steps\ngoals = 0 rad, 1.8 rad\nevery = 0.5 s\nvelocity = 1 rad/s\n")),
              HasSubstr("would send Neck to 1.8 rad"));
}

TEST(Plan, MirroredJointHasItsOwnLimit) {
  const std::string text = with(kNod, "joints = Neck\ngoal", "joints = KNEES\ngoal");
  EXPECT_EQ(refusal(with(text, "KNEES", "LegLowerR, -LegLowerL")), "");
  EXPECT_THAT(refusal(with(text, "KNEES", "LegLowerR, LegLowerL")), HasSubstr("would send LegLowerL to 0.5236 rad"));
}

TEST(Plan, RefusesATrajectoryAboveTheSpeedLimit) {
  EXPECT_THAT(refusal(phaseText("goal = sine\namplitude = 1 rad\nfrequency = 3 Hz\n")),
              AllOf(HasSubstr("would move Neck at 18.8"), HasSubstr("limited to 12.21 rad/s")));
  EXPECT_THAT(refusal(phaseText("goal = ramp\nto = 1 rad\nvelocity = 0.5 rad/s\n")), HasSubstr("limited to 0.5 rad/s"));
}

TEST(Plan, RefusesASetupPoseThatIsTooFastOrOutOfRange) {
  EXPECT_THAT(refusal(with(kNod, "pose = start", "pose = start\nArmUpperR = -0.8 rad")),
              AllOf(StartsWith("my.ini, line 6"), HasSubstr("ArmUpperR to -0.8 rad"), HasSubstr("-0.6796 to 2.301")));
  EXPECT_THAT(refusal(with(kNod, "pose = start", "pose = standing")),
              AllOf(HasSubstr("at most 1.2 rad/s"), HasSubstr("a duration of at least 2.1 s")));
}

TEST(Plan, UsesTheRobotsNarrowerRanges) {
  const Experiment nod = parseExperiment(kNod, "my.ini");
  Ranges ranges = safety::hardRanges();
  ranges[index(Joint::kNeck)] = {Rad{-0.3}, Rad{0.3}};
  EXPECT_THROW(makePlan(nod, ranges), std::runtime_error);
}

TEST(Plan, AssumesTheFullRangeAfterALimpPhase) {
  const std::string limp = with(kNod, kStep, "torque = off\n") + "[phase then]\njoints = Neck\nduration = 1 s\n";
  const Plan plan = planOf(limp + "goal = move\nto = 0 rad\n");
  EXPECT_TRUE(plan.moved[0].loose);
  EXPECT_NEAR(plan.moved[0].low, -1.93, 0.001);
  EXPECT_THAT(refusal(limp + "goal = sine\namplitude = 0.1 rad\nfrequency = 1 Hz\n"),
              HasSubstr(messages::kAddMoveBefore));
}

TEST(Plan, UnknownStartIsPlannedFromBothEndsOfTheRange) {
  const std::string limp = with(kNod, kStep, "torque = off\n") + "[phase then]\njoints = Neck\nduration = 1 s\n";
  const Plan plan = planOf(limp + "goal = move\nto = -1 rad\n");
  const JointPlan& back = plan.rounds.at(0).phases.at(1).joints.at(0);
  EXPECT_NEAR(back.low, -1.93, 0.001);
  EXPECT_NEAR(back.high, 1.69, 0.001);
  EXPECT_NEAR(back.fastest, 1.875 * 2.69, 0.05) << "from the far end, in 1 s; sampled every 4 ms";
}

TEST(Plan, TrajectoryThatMayEndEarlyLeavesARange) {
  const std::string ramp = phaseText("goal = ramp\nto = 1 rad\nuntil = rest\n");
  EXPECT_EQ(refusal(ramp), "");
  EXPECT_THAT(refusal(ramp + "[phase then]\njoints = Neck\ngoal = sine\namplitude = 0.1 rad\nfrequency = 1 Hz\n"
                             "duration = 1 s\n"),
              HasSubstr(messages::kAddMoveBefore));
}

TEST(Plan, RunsAreLimitedToHalfAnHour) {
  EXPECT_THAT(refusal(with(kNod, "duration = 1 s\n[record]", "duration = 600 s\n[sweep]\nrepeat = 3\n[record]")),
              HasSubstr("at most 1800 s"));
}

TEST(Plan, TextContainsJointsRangesAndDurations) {
  const std::string text = with(with(kNod, "pose = start\nduration = 1 s", "pose = standing\nduration = 4 s"),
                                "velocity", "until = fallen\nvelocity");
  const Experiment nod = parseExperiment(text, "my.ini");
  const std::string plan = planText(nod, makePlan(nod, safety::hardRanges()));
  for (const char* part : {"standing", "LegLowerR 2.247 to 0.928 rad", "Neck      0.000 to 0.524 rad, at most 2 rad/s",
                           "until fallen", "takes", messages::kFalls})
    EXPECT_THAT(plan, HasSubstr(part));
}

TEST(Plan, TextStatesWhetherTheRobotMayFall) {
  const auto text_of = [](const std::string& text) {
    const Experiment nod = parseExperiment(text, "my.ini");
    return planText(nod, makePlan(nod, safety::hardRanges()));
  };
  const std::string standing = text_of(with(kNod, "pose = start\nduration = 1 s", "pose = standing\nduration = 4 s"));
  EXPECT_THAT(standing, HasSubstr("\nfalls    "));
  EXPECT_THAT(standing, testing::Not(HasSubstr(messages::kFalls)));
  EXPECT_NE(standing.substr(standing.find("\nfalls")), text_of(kNod).substr(text_of(kNod).find("\nfalls")));
  EXPECT_THAT(text_of(kNod), HasSubstr(messages::kOnKnees));
  EXPECT_THAT(text_of(with(kNod, "joints = Neck", "joints = AnkleR")), HasSubstr(messages::kLegsMayMove));
}

}  // namespace
}  // namespace darwinop::experiments
