// A recording is looked at while the robot still lies as it was.
#include "gap/record/recording_check.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <span>
#include <sstream>

#include "gap/body/synthetic_robot.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

MadeRecording madeOf(const Axes& up) {
  MadeRecording made;
  made.plan.file = "up.csv", made.plan.experiment = "body_sines", made.plan.up = up;
  made.from_s = 0, made.to_s = 1e3, made.battery_v = 11.8;
  return made;
}

std::vector<std::string> problemsIn(const std::string& text, const Axes& up = {0, 1, 0}) {
  const twin::Model model = twin::readModel(twin::findModel("darwin-op"));
  return problemsOf(logs::parseLog(text, "up.csv"), "darwin-op", RestingImu{model}, madeOf(up));
}

TEST(RecordingCheck, AGoodRecordingHasNoProblem) {
  EXPECT_THAT(problemsIn(SyntheticRobot{}.recording({0, 1, 0}, 1)), IsEmpty());
}

TEST(RecordingCheck, ARobotOnTheWrongSideIsSeen) {
  const std::vector<std::string> problems = problemsIn(SyntheticRobot{}.recording({1, 0, 0}, 1), {-1, 0, 0});
  ASSERT_THAT(problems, SizeIs(1));
  EXPECT_THAT(problems.front(), HasSubstr("180"));
}

TEST(RecordingCheck, AJointThatDoesNotMoveIsNamed) {
  std::string text = SyntheticRobot{}.recording({0, 1, 0}, 1), out;
  const std::size_t head = text.find('\n');
  // Column of Neck.position.
  std::size_t column = 0;
  const std::string names = text.substr(0, head);
  for (std::size_t at = names.find("Neck.position"); at-- > 0;) column += names[at] == ',' ? 1 : 0;
  std::istringstream lines{text};
  for (std::string line; std::getline(lines, line);) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < column; ++i) begin = line.find(',', begin) + 1;
    if (!out.empty()) line.replace(begin, line.find(',', begin) - begin, "0.1");
    out += line + "\n";
  }
  const std::vector<std::string> problems = problemsIn(out);
  ASSERT_THAT(problems, SizeIs(1));
  EXPECT_THAT(problems.front(), HasSubstr("Neck"));
}

TEST(RecordingCheck, AnEmptyColumnOfTheSensorIsNamed) {
  std::istringstream lines{SyntheticRobot{}.recording({0, 1, 0}, 1)};
  std::string out;
  for (std::string line; std::getline(lines, line); out += line + "\n") {  // time_s, cycle, gyro.x
    const std::size_t begin = line.find(',', line.find(',') + 1) + 1;
    if (!out.empty()) line.erase(begin, line.find(',', begin) - begin);
  }
  const std::vector<std::string> problems = problemsIn(out);
  ASSERT_THAT(problems, SizeIs(1));
  EXPECT_THAT(problems.front(), HasSubstr("gyro.x"));
}

TEST(RecordingCheck, AJointWithoutAServoIsReportedOnlyIfItIsCommanded) {
  SyntheticRobot robot;
  robot.absent_joint = index(Joint::kNeck);
  EXPECT_THAT(problemsIn(robot.recording({0, 1, 0}, 1)), IsEmpty());
  robot.commands_absent_joint = true;
  EXPECT_THAT(problemsIn(robot.recording({0, 1, 0}, 1)),
              ElementsAre(std::string{"Neck"} + messages::kDrivenNeverAnswers));
}

/// Goals of all joints over `rows` rows: first elsewhere, then held, then in motion. `lowest`: what a robot's limits
/// let through, rad.
std::string goalsText(int away, int held, int moving, const experiments::Pose& pose, bool has_head = true,
                      double lowest = -10) {
  std::string text = "time_s,board.voltage [V]";
  for (const JointRow& joint : kJointTable)
    text += "," + std::string{joint.name} + ".asked [rad]," + std::string{joint.name} + ".commanded [rad]";
  text += "\n";
  for (int row = 0; row < away + held + moving; ++row) {
    text += std::to_string(100 + 0.016 * row) + ",11.9";
    for (const double goal : std::span{pose}.first(has_head ? kJoints : kJoints - 2)) {
      const double off = row < away ? 0.2 : row < away + held ? 0 : 0.01 * (row - away - held + 1);
      text += "," + std::to_string(goal + off) + "," + std::to_string(std::max(goal + off, lowest));
    }
    text += has_head ? "\n" : ",,,,\n";
  }
  return text;
}

TEST(UsedRows, BeginOneSecondAfterThePoseIsHeldAndEndWithThePhases) {
  const experiments::Pose& pose = experiments::startPose();
  MadeRecording made = madeOf({0, 1, 0});
  findUsedRows(logs::parseLog(goalsText(50, 100, 200, pose), "up.csv"), pose, 2.0, made);
  EXPECT_NEAR(made.from_s, 100 + 0.016 * 50 + 1, 0.02);
  EXPECT_NEAR(made.to_s, 100 + 0.016 * 149 + 2, 0.001);
  EXPECT_DOUBLE_EQ(made.battery_v, 11.9);
}

TEST(UsedRows, DoNotWaitForJointsWithoutAServo) {
  const experiments::Pose& pose = experiments::startPose();
  MadeRecording made = madeOf({0, 1, 0});
  findUsedRows(logs::parseLog(goalsText(50, 100, 200, pose, false), "up.csv"), pose, 2.0, made);
  EXPECT_NEAR(made.from_s, 100 + 0.016 * 50 + 1, 0.02);
}

TEST(UsedRows, AreFoundOnARobotWhoseLimitsShiftThePose) {
  const experiments::Pose& pose = experiments::startPose();
  MadeRecording made = madeOf({0, 1, 0});
  const double lowest = *std::ranges::min_element(pose) + 0.1;
  findUsedRows(logs::parseLog(goalsText(50, 100, 200, pose, true, lowest), "up.csv"), pose, 2.0, made);
  EXPECT_NEAR(made.from_s, 100 + 0.016 * 50 + 1, 0.02);
}

// The safety layer may follow a jump of the goal slowly.
TEST(UsedRows, BeginWhenWhatIsSentRests) {
  const experiments::Pose& pose = experiments::startPose();
  std::string text = goalsText(0, 200, 100, pose);
  std::istringstream lines{text};
  std::string line, changed;
  for (int row = -1; std::getline(lines, line); ++row, changed += line + "\n")
    if (row >= 0 && row < 40)
      line.replace(line.rfind(',') + 1, line.npos, std::to_string(pose.back() + 0.2 - row * 0.005));
  MadeRecording made = madeOf({0, 1, 0});
  findUsedRows(logs::parseLog(changed, "up.csv"), pose, 2.0, made);
  EXPECT_NEAR(made.from_s, 100 + 0.016 * 40 + 1, 0.02);
}

// The recording's clock is that of the computer: it was not started with the first recording.
TEST(UsedRows, TheSessionGoesOnFromTheFirstRowNotFromTheClocksZero) {
  const experiments::Pose& pose = experiments::startPose();
  MadeRecording made = madeOf({0, 1, 0});
  made.session_s = 120;
  findUsedRows(logs::parseLog(goalsText(50, 100, 200, pose), "up.csv"), pose, 2.0, made);
  EXPECT_NEAR(made.session_s, 120 + 0.016 * 50 + 1, 0.02);
}

TEST(UsedRows, APoseThatIsNeverHeldIsAnError) {
  const experiments::Pose& pose = experiments::startPose();
  MadeRecording made = madeOf({0, 1, 0});
  EXPECT_THROW(findUsedRows(logs::parseLog(goalsText(50, 30, 200, pose), "up.csv"), pose, 2.0, made), BadInput);
}

TEST(RecordedCase, ReadsBackWithWhatIsUsedOfEachFile) {
  BodyTexts texts;
  MadeRecording one = madeOf({0, 1, 0}), two = madeOf({-1, 0, 0});
  two.plan.file = "side.csv", two.plan.held_out = true;
  one.from_s = 0.32, one.to_s = 1.6;
  texts.json = bodyCaseJson("robot", "darwin-op", RecordedRobot::kPhysical, {one, two});
  const BodyCase read = texts.read();
  ASSERT_EQ(read.logs.size(), 2u);
  EXPECT_EQ(read.logs[0].rows(), 81u);
  EXPECT_EQ(read.joint(0, 3).rows(), 81u);
  EXPECT_DOUBLE_EQ(read.logs[0].time_s.front(), 0);
  EXPECT_TRUE(read.logs[1].held_out);
  EXPECT_GT(read.sigmaOf("friction"), 0);
  EXPECT_NEAR(read.sigmaOf(kUpSigma), 0.5 * kPi / 180, 0.005) << "a stand is set to half a degree";
  EXPECT_THAT(read.warnings, IsEmpty());
}

TEST(RecordedCase, ThePlanShowsAllThreeAxesOfGravityAReleaseARepeatAndAHeldOutLog) {
  std::vector<std::string> held_out, repeats;
  for (const PlannedRecording& one : plannedRecordings(false)) {
    EXPECT_TRUE(one.up.has_value());
    if (one.held_out) held_out.push_back(one.file);
    if (!one.repeat_of.empty()) repeats.push_back(one.repeat_of);
  }
  EXPECT_THAT(held_out, ElementsAre("right_side.csv"));
  EXPECT_THAT(repeats, ElementsAre("upright.csv"));
  EXPECT_EQ(plannedRecordings(true).back().setup, BodySetup::kFloor);
}

}  // namespace
}  // namespace darwinop::gap
