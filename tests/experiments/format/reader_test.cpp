// Experiment files: syntax and error messages.
#include "experiments/format/reader.hpp"

#include <gmock/gmock.h>

#include "experiments/format/messages.hpp"
#include "experiments/format/texts.hpp"

namespace darwinop::experiments {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST(ExperimentReader, ReadsNumbersWithUnits) {
  const Experiment nod = parseExperiment(kNod, "my.ini");
  const Phase& turn = nod.rounds.at(0).phases.at(0);
  EXPECT_EQ(nod.name, "nod");
  EXPECT_EQ(turn.joints.at(0).joint, Joint::kNeck);
  EXPECT_NEAR(turn.goal.to, 30 * kRadPerDegree, 1e-12);  // one multiplication
  EXPECT_EQ(turn.velocity, 2);
  EXPECT_EQ(turn.p_gain, 4) << "default gain";
  EXPECT_EQ(nod.record_joints, std::vector{Joint::kNeck});
}

TEST(ExperimentReader, SweepMakesOneRoundPerValue) {
  const std::string text =
      with(kNod, "velocity = 2 rad/s", "velocity = sweep") + "[sweep]\nvalues = 1 rad/s, 60 deg/s\n";
  const Experiment nod = parseExperiment(text, "my.ini");
  ASSERT_EQ(nod.rounds.size(), 2U);
  EXPECT_EQ(nod.rounds[0].phases[0].velocity, 1);
  EXPECT_NEAR(nod.rounds[1].phases[0].velocity, 60 * kRadPerDegree, 1e-12);
  EXPECT_EQ(nod.rounds[1].label, "velocity = 60 deg/s");
}

TEST(ExperimentReader, RepeatMakesRoundsWithoutAValue) {
  EXPECT_EQ(parseExperiment(kNod + "[sweep]\nrepeat = 3\n", "my.ini").rounds.size(), 3U);
}

TEST(ExperimentReader, MinusMirrorsAJoint) {
  const Experiment nod = parseExperiment(with(kNod, "joints = Neck\ngoal", "joints = AnkleR, -AnkleL\ngoal"), "my.ini");
  EXPECT_EQ(nod.rounds[0].phases[0].joints[0].sign, 1);
  EXPECT_EQ(nod.rounds[0].phases[0].joints[1].sign, -1);
}

TEST(ExperimentReader, AllStandsForEveryJointWithTheLeftOnesMirrored) {
  const Experiment nod = parseExperiment(with(with(kNod, "joints = Neck\ngoal", "joints = all\ngoal"),
                                              "[record]\njoints = Neck", "[record]\njoints = all"),
                                         "my.ini");
  const std::vector<Moved>& joints = nod.rounds[0].phases[0].joints;
  ASSERT_EQ(joints.size(), kJoints);
  EXPECT_EQ(joints[index(Joint::kAnkleR)].sign, 1);
  EXPECT_EQ(joints[index(Joint::kAnkleL)].sign, -1);
  EXPECT_EQ(joints[index(Joint::kHead)].sign, 1);
  EXPECT_EQ(nod.record_joints.size(), kJoints);
}

TEST(ExperimentReader, ATrunkIsFreeUnlessItIsClamped) {
  EXPECT_FALSE(parseExperiment(kNod, "my.ini").setup.is_clamped);
  EXPECT_TRUE(parseExperiment(with(kNod, "pose = start", "pose = start\ntrunk = clamped"), "my.ini").setup.is_clamped);
  EXPECT_THAT(refusal(with(kNod, "pose = start", "pose = start\ntrunk = glued")), HasSubstr("line 6"));
}

struct Wrong {
  const char *line, *instead;
  int number;  // of the line that is named
  std::vector<std::string> says;
};

class ExperimentErrors : public testing::TestWithParam<Wrong> {};

TEST_P(ExperimentErrors, NameFileLineAndAllowedValues) {
  const Wrong& wrong = GetParam();
  const std::string sentence = refusal(with(kNod, wrong.line, wrong.instead));
  EXPECT_THAT(sentence, StartsWith("my.ini, line " + std::to_string(wrong.number) + ": "));
  for (const std::string& part : wrong.says) EXPECT_THAT(sentence, HasSubstr(part));
}

INSTANTIATE_TEST_SUITE_P(
    Lines, ExperimentErrors,
    testing::Values(
        Wrong{"velocity =", "velocty =", 11, {"'velocty'", "velocity?", "torque_limit"}},
        Wrong{"velocity = 2 rad/s", "velocity = 2", 11, {"'2' is not a speed", "rad/s, deg/s, rpm"}},
        Wrong{"velocity = 2 rad/s", "velocity = 20 rad/s", 11, {"'20 rad/s'", "0.0119 to 12.21 rad/s"}},
        Wrong{"velocity = 2 rad/s", "velocity = nan rad/s", 11, {"is not a speed"}},
        Wrong{"velocity = 2 rad/s\n", "", 7, {"goal = step needs 'velocity'"}},
        Wrong{"duration = 1 s\n[record]", "[record]", 7, {"needs 'duration'"}},
        Wrong{"joints = Neck\ngoal", "joints = Nek\ngoal", 8, {"no joint 'Nek'", "did you mean Neck?", "ShoulderR"}},
        Wrong{"joints = Neck\ngoal", "joints = Neck, -Neck\ngoal", 8, {"Neck is listed twice"}},
        Wrong{"goal = step", "goal = stop", 9, {"'stop' is not allowed", "step?", "multisine"}},
        Wrong{"goal = step", "goal = sine", 7, {"goal = sine needs 'amplitude'"}},
        Wrong{"to = 30 deg",
              "to = 30 deg\nperiod = 1 s",
              11,
              {"'period' has no meaning for goal = step", "to, velocity"}},
        Wrong{"goal = step", "torque = off\ngoal = step", 10, {"'torque'", "'goal'"}},
        Wrong{"velocity = 2 rad/s", "velocity = sweep", 11, {"needs a section [sweep]"}},
        Wrong{"velocity = 2 rad/s", "velocity = 2 rad/s\nwithin = 0.1 rad", 12, {"until = arrival"}},
        Wrong{"pose = start", "pose = stand", 5, {"no pose 'stand'", "start, standing"}},
        Wrong{"pose = start", "pose = start\npose = start", 6, {"'pose' is set twice"}},
        Wrong{"[record]", "[recrod]", 13, {"no section [recrod]", "record?", "[phase NAME]"}},
        Wrong{"[phase turn]", "[phase]", 7, {messages::kPhaseNeedsName}},
        Wrong{"name = nod", "name = ../nod", 2, {messages::kNameLetters}},
        Wrong{"title = The head nods\n", "", 1, {"needs 'title'"}},
        Wrong{"pose = start\n", "pose = start\nhello\n", 6, {"'hello'", messages::kNeitherSectionNorPair}}));

TEST(ExperimentReader, NamesAMissingSection) {
  EXPECT_THAT(refusal("[experiment]\nname = a\ntitle = b\n"), AllOf(StartsWith("my.ini"), HasSubstr("[setup]")));
}

TEST(ExperimentReader, SweptValuesAreCheckedAgainstTheirKey) {
  const std::string text = with(kNod, "velocity = 2 rad/s", "velocity = sweep") + "[sweep]\nvalues = 1 rad/s, 5\n";
  EXPECT_THAT(refusal(text), AllOf(StartsWith("my.ini, line 11"), HasSubstr("'5' is not a speed")));
}

TEST(ExperimentReader, UnusedSweepIsRefused) {
  EXPECT_THAT(refusal(kNod + "[sweep]\nvalues = 1, 2\n"), HasSubstr(messages::kSweepUnused));
}

}  // namespace
}  // namespace darwinop::experiments
