// A joint of the whole robot as a bench: the pendulum of its body is what a case simulates.
#include "gap/case/robot/joint_case.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "experiments/logs/read_log.hpp"
#include "gap/case/robot/alone.hpp"
#include "gap/case/robot/recorded_swing.hpp"
#include "gap/plant/bench/roll_out.hpp"
#include "twin/body/pendulum.hpp"

namespace darwinop::gap {
namespace {

using JointCase = Folder;

TEST_F(JointCase, OfTheTwinIsSimulatedAsItMoved) {
  std::ofstream{file("swing.csv")} << recordedSwing();
  writeJointCase({.recordings = {file("swing.csv")}, .held_out = {}}, file("case"));
  const Case made = readCase(file("case"));
  ASSERT_EQ(made.logs.size(), 1U);
  EXPECT_EQ(made.joint, Joint::kShoulderR) << "whose servo a result is of";
  EXPECT_NEAR(made.model.servo.supply_v, 11.8, 1e-9);
  Trace trace;
  rollOut(made, 0, baselineOf(made), {}, trace);
  double sum = 0;
  for (std::size_t row = 0; row < trace[kPositionSignal].size(); ++row)
    sum += std::pow(trace[kPositionSignal][row] - made.logs[0].position_rad[row], 2);
  EXPECT_LT(std::sqrt(sum / static_cast<double>(trace[kPositionSignal].size())), 0.003) << "two steps of the encoder";
}

TEST_F(JointCase, OfARecordingThatWasCutOffHasAWarning) {
  std::string text = recordedSwing();
  std::ofstream{file("swing.csv")} << text;
  EXPECT_TRUE(writeJointCase({.recordings = {file("swing.csv")}, .held_out = {}}, file("whole")).warnings.empty());
  std::ofstream{file("cut.csv")} << text.erase(text.find("# end"));
  const JointCaseNotes notes = writeJointCase({.recordings = {file("cut.csv")}, .held_out = {}}, file("cut"));
  ASSERT_EQ(notes.warnings.size(), 1U);
  EXPECT_THAT(notes.warnings.front(), testing::StartsWith(file("cut.csv") + logs::kNoEnd));
}

// A part begins with the row of its first new goal; the joint rests where it was held until then.
TEST_F(JointCase, BeginsAtTheGoalOfTheRowBefore) {
  std::ofstream{file("swing.csv")} << recordedSwing(0, {}, "50");
  writeJointCase({.recordings = {file("swing.csv")}, .held_out = {}}, file("case"));
  const Case made = readCase(file("case"));
  ASSERT_EQ(made.logs.size(), 1U);
  const Trajectory& log = made.logs[0];
  ASSERT_GT(std::abs(log.goal_rad[0] - *log.goal_before_rad), 0.6);
  Trace trace;
  rollOut(made, 0, baselineOf(made), {}, trace);
  double sum = 0;
  constexpr std::size_t kFirst = 10;
  for (std::size_t row = 0; row < kFirst; ++row)
    sum += std::pow(trace[kPositionSignal][row] - log.position_rad[row], 2);
  EXPECT_LT(std::sqrt(sum / kFirst), 0.01) << "the body stands free: without what was held it is 0.4";
}

// The clock of a recording is the computer's, which may have run for days.
TEST_F(JointCase, ASessionBeginsWithItsFirstRecording) {
  constexpr double kDays = 2e5;  // s
  std::ofstream{file("first.csv")} << recordedSwing(kDays);
  std::ofstream{file("second.csv")} << recordedSwing(kDays + 60);
  writeJointCase({.recordings = {file("first.csv"), file("second.csv")}, .held_out = {}}, file("case"));
  const Case made = readCase(file("case"));
  ASSERT_EQ(made.logs.size(), 2U);
  EXPECT_NEAR(made.logs[0].session_start_s, 1.5, 0.1);
  EXPECT_NEAR(made.logs[1].session_start_s, 8 + 1.5, 0.1);
}

// --keep comes last, whenever it was recorded.
TEST_F(JointCase, TheDatesOfItsRecordingsAreTheClockOfASession) {
  const auto recordedAt = [](const std::string& minute) {
    std::string text = recordedSwing();
    return text.insert(text.find("# experiment"), "# date: 2026-05-01T10:" + minute + ":00Z\n");
  };
  std::ofstream{file("early.csv")} << recordedAt("00");
  std::ofstream{file("late.csv")} << recordedAt("10");
  writeJointCase({.recordings = {file("late.csv")}, .held_out = {file("early.csv")}}, file("case"));
  const Case made = readCase(file("case"));
  ASSERT_EQ(made.logs.size(), 2U);
  EXPECT_NEAR(made.logs[0].session_start_s, 600 + 1.5, 0.1);
  EXPECT_NEAR(made.logs[1].session_start_s, 1.5, 0.1);
}

TEST_F(JointCase, HasTheNameOfItsFolderAlsoWithASlashBehindIt) {
  std::ofstream{file("swing.csv")} << recordedSwing();
  writeJointCase({.recordings = {file("swing.csv")}, .held_out = {}}, file("shoulder/"));
  EXPECT_EQ(readCase(file("shoulder")).name, "shoulder");
}

// A battery's voltage falls in a session, and repeats of a day have the names of those of another.
TEST_F(JointCase, EachRecordingHasItsOwnSupplyAndRowsWhateverItsName) {
  std::string low = recordedSwing();
  for (std::size_t at = low.find(",11.8,"); at != low.npos; at = low.find(",11.8,", at + 1))
    low.replace(at, 6, ",10.6,");
  for (const char* const day : {"one", "two"}) std::filesystem::create_directory(file(day));
  std::ofstream{file("one/swing.csv")} << recordedSwing();
  std::ofstream{file("two/swing.csv")} << low;
  writeJointCase({.recordings = {file("one/swing.csv")}, .held_out = {file("two/swing.csv")}}, file("case"));
  const Case made = readCase(file("case"));
  ASSERT_EQ(made.logs.size(), 2U);
  EXPECT_NEAR(supplyOf(made, made.logs[0]), 11.8, 1e-9);
  EXPECT_NEAR(supplyOf(made, made.logs[1]), 10.6, 1e-9);
}

// readCase() refuses a model whose body it does not find.
TEST_F(JointCase, HasTheBodyOfItsModelUnderTheSameName) {
  const std::filesystem::path shipped = twin::findModel("darwin-op"), body = shipped.parent_path() / "darwin-op.xml";
  std::filesystem::create_directories(file("own/bodies"));
  std::filesystem::copy_file(body, file("own/bodies/own.xml"));
  std::ofstream{file("own/own.ini")} << "[model]\nname = own\n[body]\nxml = bodies/own.xml\n";
  std::ofstream{file("swing.csv")} << recordedSwing();
  writeJointCase({.model = file("own/own.ini"), .recordings = {file("swing.csv")}, .held_out = {}}, file("case"));
  EXPECT_EQ(readCase(file("case")).model.folder, file("case"));
}

// Where the trunk leans to the side, the shoulder carries less weight at the same inertia.
TEST_F(JointCase, EachRecordingHasItsOwnArm) {
  std::ofstream{file("upright.csv")} << recordedSwing();
  std::ofstream{file("leaning.csv")} << withAccelerometer(recordedSwing(), "6.9,0,6.9");
  const std::vector<std::string> said =
      writeJointCase({.recordings = {file("upright.csv"), file("leaning.csv")}, .held_out = {}}, file("case")).logs;
  const Case made = readCase(file("case"));
  ASSERT_EQ(made.logs.size(), 2U);
  EXPECT_LT(made.logs[1].length_m.value() * made.logs[1].payload_kg,
            0.8 * made.logs[0].length_m.value() * made.logs[0].payload_kg);
  for (std::size_t i = 0; i < 2; ++i) {
    const twin::Pendulum arm = armOf(made, made.logs[i]);
    char inertia[40];
    std::snprintf(inertia, sizeof inertia, "inertia %.5f kg m2", arm.payload_kg * arm.length_m * arm.length_m);
    EXPECT_THAT(said[i], testing::HasSubstr(inertia));
  }
}

// The model says how its sensor deviates, and the sensor does.
TEST_F(JointCase, HangsWhereItHangsWhateverItsModelSaysOfTheSensor) {
  // Leaning forward: right 0, forward -1.9, up 9.6. Read as y, -x, z; with a bias and a scale.
  std::ofstream{file("true.csv")} << withAccelerometer(recordedSwing(), "0,-1.9,9.6");
  std::ofstream{file("read.csv")} << withAccelerometer(recordedSwing(), "-1.4,0,10.56");
  const std::filesystem::path shipped = twin::findModel("darwin-op"), body = shipped.parent_path() / "darwin-op.xml";
  std::filesystem::copy_file(body, file("own.xml"));
  std::ofstream{file("own.ini")} << "[model]\nname = own\n[body]\nxml = own.xml\n[imu]\naccel_axes = 2, -1, 3\n"
                                    "accel_bias = 0.5, 0, 0 m/s2\naccel_scale = 1, 1, 1.1\n";
  const auto hangs = [&](const std::string& recording, const std::string& model) {
    const std::string said =
        writeJointCase({.model = model, .recordings = {file(recording)}, .held_out = {}}, file("case")).logs.at(0);
    return said.substr(said.find("kg m2"));
  };
  EXPECT_EQ(hangs("read.csv", file("own.ini")), hangs("true.csv", "darwin-op"));
}

TEST_F(JointCase, NeedsAPartInWhichTheJointMovesAlone) {
  std::ofstream{file("swing.csv")} << recordedSwing();
  const logs::Log log = logs::readLog(file("swing.csv"));
  const std::vector<AlonePart> parts = aloneParts(log, Joint::kShoulderR);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(parts[0].from_s, 1.5, 0.05) << "the other joints are where they stay";
  EXPECT_NEAR(parts[0].to_s, 8, 0.05);
  EXPECT_NEAR(parts[0].angles_rad[index(Joint::kArmUpperR)], -0.65, 0.02);
  try {
    writeJointCase({.joint = Joint::kNeck, .recordings = {file("swing.csv")}, .held_out = {}}, file("case"));
    ADD_FAILURE() << "of a joint that was not recorded";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("Neck"));
  }
}

TEST(JointPendulum, HangsWhereDownIs) {
  const twin::Model model = twin::readModel(twin::findModel("darwin-op"));
  std::array<double, kJoints> pose{};
  pose[index(Joint::kArmLowerR)] = -1.55;
  const twin::JointPendulum upright = twin::pendulumOf(model, Joint::kShoulderR, pose, kUpright);
  // Leaning forward by 0.2: what is forward of the trunk points down.
  const twin::JointPendulum leaning =
      twin::pendulumOf(model, Joint::kShoulderR, pose, {0, -9.81 * std::sin(0.2), 9.81 * std::cos(0.2)});
  EXPECT_NEAR(std::abs(leaning.hangs_at_rad - upright.hangs_at_rad), 0.2, 1e-6);
  EXPECT_NEAR(leaning.weight_nm, upright.weight_nm, 1e-9);
  EXPECT_NEAR(leaning.inertia_kgm2, upright.inertia_kgm2, 1e-12);
}

TEST(JointPendulum, AnUprightAxisCarriesNoWeight) {
  const twin::Model model = twin::readModel(twin::findModel("darwin-op"));
  const twin::JointPendulum neck = twin::pendulumOf(model, Joint::kNeck, {}, kUpright);
  EXPECT_NEAR(neck.weight_nm, 0, 1e-9);
  EXPECT_GT(neck.inertia_kgm2, 1e-5);
}

}  // namespace
}  // namespace darwinop::gap
