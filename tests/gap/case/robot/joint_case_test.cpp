// A joint of the whole robot as a bench: the pendulum of its body is what a case simulates.
#include "gap/case/robot/joint_case.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>

#include "experiments/logs/read_log.hpp"
#include "gap/case/robot/alone.hpp"
#include "gap/plant/bench/roll_out.hpp"
#include "twin/body/pendulum.hpp"
#include "twin/body/robot_body.hpp"

namespace darwinop::gap {
namespace {

constexpr double kRowTime = 0.016;
constexpr std::array<double, 3> kUpright{0, 0, 9.81};

std::string nameOf(std::size_t joint) {
  return std::string{kJointTable[joint].name};
}

/// What the runtime would have recorded of the twin: the right arm is stretched, swings at the shoulder, and goes limp.
/// `began_s`: of the recording's clock. `silent`: a joint that is neither driven nor answers.
std::string recordedSwing(double began_s = 0, std::optional<Joint> silent = {}) {
  twin::RobotBody body{twin::readModel(twin::findModel("darwin-op"))};
  Drives drives;
  for (std::size_t i = 0; i < kJoints; ++i)
    drives[i] = {.torque_on = true,
                 .goal_rad = body.state().joint[i].position_rad,
                 .speed_limit_rad_s = std::numeric_limits<double>::infinity(),
                 .torque_limit = 1,
                 .supply_v = 11.8};
  std::string text =
      "# darwinop log, format 1\n# robot: darwin-op\n# experiment: swing\ntime_s,cycle,board.voltage [V]";
  for (const char axis : {'x', 'y', 'z'}) text += std::string{",accelerometer."} + axis + " [m/s2]";
  for (std::size_t i = 0; i < kJoints; ++i)
    text += "," + nameOf(i) + ".commanded [rad]," + nameOf(i) + ".position [rad]";
  text +=
      ",ShoulderR.asked_p_gain,ShoulderR.asked_speed [rad/s],ShoulderR.velocity [rad/s],ShoulderR.load,"
      "ShoulderR.voltage [V],ShoulderR.temperature [degC]\n";

  ServoDrive& shoulder = drives[index(Joint::kShoulderR)];
  const auto number = [](double value) { return "," + std::to_string(value); };
  for (int cycle = 1; cycle * kRowTime < 8; ++cycle) {
    const double t = cycle * kRowTime;
    const BodyState& state = body.state();
    text += std::to_string(began_s + t) + "," + std::to_string(cycle) + ",11.8";
    for (const double accel : state.accel_m_s2) text += number(accel);
    const double share = std::min(t / 1.5, 1.0);  // to the pose
    drives[index(Joint::kArmUpperR)].goal_rad = share * -0.65;
    drives[index(Joint::kArmLowerR)].goal_rad = share * -1.55;
    if (t < 1.5) shoulder.goal_rad *= 1 - kRowTime / (1.5 - t + kRowTime);
    if (t > 3) shoulder.goal_rad = t < 3.8 ? 0.7 : t < 4.6 ? -0.3 : 0.9;
    shoulder.torque_on = t < 5.5;
    for (std::size_t i = 0; i < kJoints; ++i)
      text += static_cast<Joint>(i) == silent
                  ? ",,"
                  : (drives[i].torque_on ? number(drives[i].goal_rad) : ",") + number(state.joint[i].position_rad);
    const JointMotion& reading = state.joint[index(Joint::kShoulderR)];
    text += ",4,," + std::to_string(reading.velocity_rad_s) + number(reading.load) + ",,30\n";
    for (int ms = 0; ms < 16; ++ms) body.step(std::chrono::milliseconds{1}, drives);
  }
  return text + "# end\n";
}

class Folder : public testing::Test {
 protected:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "darwinop-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~Folder() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};
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

// As with `board = none` in robot.ini. The servo reports its voltage.
TEST_F(JointCase, OfARobotWithoutABoardIsUprightWithTheVoltageOfTheServo) {
  std::istringstream lines{recordedSwing()};
  std::string all, none;
  for (std::string line; std::getline(lines, line);) {
    if (std::isdigit(line.front()) != 0) {
      const std::size_t board = line.find(',', line.find(',') + 1);
      std::size_t end = board;
      for (int column = 0; column < 4; ++column) end = line.find(',', end + 1);
      all += line + "\n";
      line.replace(board, end - board, ",,,,");
      none += line + "\n";
    } else {
      all += line + "\n", none += line + "\n";
    }
  }
  std::ofstream{file("swing.csv")} << none;
  const std::vector<std::string> said =
      writeJointCase({.recordings = {file("swing.csv")}, .held_out = {}}, file("case"));
  EXPECT_THAT(said, testing::ElementsAre(testing::AllOf(testing::HasSubstr(messages::kTakenAsUpright),
                                                        testing::HasSubstr(messages::kSupplyOfModel))));
  for (std::size_t at = none.find(",,30\n"); at != none.npos; at = none.find(",,30\n", at + 1))
    none.replace(at, 5, ",10.7,30\n");
  std::ofstream{file("swing.csv")} << none;
  writeJointCase({.recordings = {file("swing.csv")}, .held_out = {}}, file("with"));
  EXPECT_NEAR(readCase(file("with")).model.servo.supply_v, 10.7, 1e-9);
  std::ofstream{file("swing.csv")} << all;
  writeJointCase({.recordings = {file("swing.csv")}, .held_out = {}}, file("board"));
  EXPECT_NEAR(readCase(file("with")).logs[0].payload_kg, readCase(file("board")).logs[0].payload_kg, 0.002);
}

// As `absent` of robot.ini, or with a broken cable.
TEST_F(JointCase, DoesNotDependOnServosOfOtherLimbs) {
  std::map<std::string, Case> made;
  for (const auto& [of, silent] : {std::pair{"all", std::optional<Joint>{}}, {"no_neck", Joint::kNeck}}) {
    std::ofstream{file("swing.csv")} << recordedSwing(0, silent);
    writeJointCase({.recordings = {file("swing.csv")}, .held_out = {}}, file(of));
    made[of] = readCase(file(of));
  }
  const Trajectory &all = made["all"].logs.at(0), &no_neck = made["no_neck"].logs.at(0);
  EXPECT_EQ(no_neck.position_rad, all.position_rad);
  EXPECT_DOUBLE_EQ(no_neck.payload_kg, all.payload_kg);
  EXPECT_DOUBLE_EQ(made["no_neck"].pendulum.length_m, made["all"].pendulum.length_m);
  std::ofstream{file("no_elbow.csv")} << recordedSwing(0, Joint::kArmLowerR);
  try {
    writeJointCase({.recordings = {file("no_elbow.csv")}, .held_out = {}}, file("case"));
    ADD_FAILURE() << "the angle of the elbow is in the weight of the arm";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(std::string{"ArmLowerR"} + twin::messages::kAngleUnknown));
  }
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
