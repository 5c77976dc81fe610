// robot.ini: what it may say, what it may not, and what holds in the end.
#include "connect/robot_file.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>
#include <vector>

#include "connect/messages.hpp"
#include "connect/robot_file_finding.hpp"
#include "connect/setting.hpp"
#include "core/conversions.hpp"
#include "core/text/ini_text.hpp"
#include "hal/text_file.hpp"
#include "runtime/environment.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::connect {
namespace {

using namespace std::chrono_literals;
using runtime::Environment;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

template <class Action>
std::string errorOf(const Action& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}
std::string errorIn(const std::string& text) {
  return errorOf([&] { static_cast<void>(parseRobotFile(text, "robot.ini")); });
}

TEST(RobotFile, IsMissedAtARealPortOnly) {
  const auto at = [](const RobotFile& robot, const char* port) { return robotFileFinding(robot, port); };
  const cm730::Finding missed = at({}, "/dev/ttyUSB7");
  EXPECT_EQ(missed.level, cm730::Level::kWarning);
  EXPECT_THAT(missed.remedy, HasSubstr("DARWINOP_ROBOT_FILE"));
  EXPECT_EQ(at({}, "/dev/pts/7").level, cm730::Level::kOk);
  EXPECT_EQ(at(parseRobotFile("", "robot.ini"), "/dev/ttyUSB7").level, cm730::Level::kOk);
}

TEST(RobotFile, AStartWithoutItAtARealPortWarns) {
  EXPECT_THAT(robotFileWarning({}, "/dev/ttyUSB7"), AllOf(HasSubstr(messages::kNoRobotFile), EndsWith("\n")));
  EXPECT_EQ(robotFileWarning({}, "/dev/pts/7"), "");
}

TEST(RobotFile, ReadsEverySection) {
  const RobotFile robot = parseRobotFile(
      "[Robot]\nport = /dev/ttyUSB1\ncamera = /dev/video2\nperiod_ms = 8\ngroup = robots\n"
      "controller_user = student\n"
      "[Safety]\nstall_ms = 250\n[Limits]\nNeck = -0.5, 0.5\n[Offsets]\nNeck = 0.1\nHead = -0.2 # as measured\n",
      "robot.ini");
  EXPECT_EQ(robot.path, "robot.ini");
  EXPECT_EQ(robot.serialPort(), "/dev/ttyUSB1");
  EXPECT_EQ(robot.camera, "/dev/video2");
  EXPECT_EQ(robot.period, 8ms);
  EXPECT_EQ(robot.group, "robots");
  EXPECT_EQ(robot.controller_user, "student");
  EXPECT_EQ(robot.safety.stall_ms, 250);
  EXPECT_EQ(robot.safety.range[index(Joint::kNeck)].high.value, 0.5);
  EXPECT_EQ(robot.offsets.ticks(Joint::kNeck), 65);
  EXPECT_EQ(robot.offsets.ticks(Joint::kHead), -130);
  EXPECT_EQ(robot.offsets.ticks(Joint::kShoulderR), 0);
}

TEST(RobotFile, ReadsTheCalibrationOfTheInertialSensor) {
  const RobotFile robot = parseRobotFile(
      "[Imu]\nGyro_Bias = 0.1, -0.2,0.3 # 2026\naccel_bias = 1, 2, -3\naccel_scale = 1.1, 0.9, 1\n"
      "mounting = 0.01, 0.02, -0.03\n",
      "robot.ini");
  EXPECT_EQ(robot.imu, (cm730::ImuCalibration{.gyro_bias_rad_s = {0.1, -0.2, 0.3},
                                              .accel_bias_m_s2 = {1, 2, -3},
                                              .accel_scale = {1.1, 0.9, 1},
                                              .mounting_rad = {0.01, 0.02, -0.03}}));
  EXPECT_THAT(describe(robot), HasSubstr(messages::kImuIsCalibrated));
  EXPECT_THAT(describe(parseRobotFile("", "robot.ini")), testing::Not(HasSubstr(messages::kImuIsCalibrated)));
}

TEST(RobotFile, WhatItDoesNotNameIsNotThere) {
  const RobotFile robot = parseRobotFile("", "robot.ini");
  EXPECT_FALSE(robot.port || robot.camera || robot.period);
  EXPECT_EQ(robot.serialPort(), "/dev/ttyUSB0");
  EXPECT_TRUE(robot.safety.named.none());
}

TEST(RobotFile, NoneIsTheOnlyBoardThatCanBeNamed) {
  const RobotFile robot = parseRobotFile("[Robot]\nboard = None\n", "robot.ini");
  EXPECT_TRUE(robot.permitted.no_board);
  EXPECT_THAT(describe(robot), HasSubstr(messages::kHasNoBoard));
  EXPECT_FALSE(parseRobotFile("[Robot]\nabsent =\n", "robot.ini").permitted.no_board);
  for (const char* other : {"cm-730", "yes", ""})
    EXPECT_THAT(errorIn(std::string{"[Robot]\nboard = "} + other + "\n"),
                AllOf(StartsWith(text::where("robot.ini", 2)), HasSubstr("[Robot] board"), HasSubstr("none")));
}

TEST(RobotFile, NamesJointsThatTheRobotLacks) {
  const RobotFile robot = parseRobotFile("[Robot]\nabsent = neck , Head\n", "robot.ini");
  EXPECT_TRUE(robot.safety.absent[index(Joint::kNeck)] && robot.safety.absent[index(Joint::kHead)]);
  EXPECT_EQ(robot.safety.absent.count(), 2U);
  EXPECT_EQ(safetyOn(robot, {}, "config.ini").absent, robot.safety.absent) << "it reaches the loop";
  EXPECT_THAT(describe(robot), HasSubstr("absent: Neck Head"));
  EXPECT_TRUE(parseRobotFile("[Robot]\nabsent =\n", "robot.ini").safety.absent.none());
}

TEST(RobotFile, RefusesAnAbsentJointThatDoesNotExistWithItsLine) {
  for (const char* names : {"Nose", "Neck, Nose", "Neck,", ",", "Neck Head", "19"})
    EXPECT_THAT(errorIn(std::string{"[Robot]\nport = /dev/ttyUSB0\nabsent = "} + names + "\n"),
                AllOf(StartsWith(text::where("robot.ini", 3)), HasSubstr("[Robot] absent"), HasSubstr("Neck, Head")))
        << names;
  std::string all;
  for (const JointRow& joint : kJointTable) all += (all.empty() ? "" : ", ") + std::string{joint.name};
  EXPECT_THAT(errorIn("[Robot]\nabsent = " + all + "\n"), HasSubstr(messages::kNoJointLeft));
}

TEST(RobotFile, NamesServoModelsThatItPermits) {
  EXPECT_TRUE(parseRobotFile("[Robot]\nservo_models =\n", "robot.ini").permitted.servo_models.none());
  const RobotFile robot = parseRobotFile("[Robot]\nservo_models = mx-106 , MX-64\n", "robot.ini");
  for (const ServoModel& model : kServoModels)
    EXPECT_EQ(isDriven(model, robot.permitted.servo_models), !model.name.ends_with("(2.0)")) << model.name;
  EXPECT_THAT(describe(robot), HasSubstr("MX-64 MX-106"));
}

TEST(RobotFile, RefusesAServoModelThatCannotBePermitted) {
  for (const char* models : {"MX-28(2.0)", "AX-12", "310", "MX-64,", "MX-64 MX-106"})
    EXPECT_THAT(
        errorIn(std::string{"[Robot]\nservo_models = "} + models + "\n"),
        AllOf(StartsWith(text::where("robot.ini", 2)), HasSubstr("[Robot] servo_models"), HasSubstr("MX-64, MX-106")))
        << models;
}

TEST(RobotFile, SectionsKeysAndJointsMayBeInAnyCase) {
  const RobotFile robot = parseRobotFile("[robot]\nPORT : \"/dev/ttyACM0\"\n[OFFSETS]\nneck = 0.1\n", "robot.ini");
  EXPECT_EQ(robot.port, "/dev/ttyACM0");
  EXPECT_EQ(robot.offsets.ticks(Joint::kNeck), 65);
}

struct Wrong {
  const char* text;
  int line;
  std::vector<const char*> facts;  // what the error names
};
class WrongRobotFile : public ::testing::TestWithParam<Wrong> {};
INSTANTIATE_TEST_SUITE_P(
    Each, WrongRobotFile,
    ::testing::Values(
        Wrong{"[Robot]\nport = ttyUSB0", 2, {"[Robot] port = ttyUSB0: ", "/dev/ttyUSB0"}},
        Wrong{"[Robot]\nport =", 2, {"[Robot] port = : ", "/dev/ttyUSB0"}},
        Wrong{"[Robot]\ncamera = 0", 2, {"[Robot] camera = 0: ", "/dev/video0"}},
        Wrong{"[Robot]\nperiod_ms = 4", 2, {"[Robot] period_ms = 4: ", "8 to 50", "16"}},
        Wrong{"[Robot]\nperiod_ms = 60", 2, {"[Robot] period_ms = 60: ", "8 to 50"}},
        Wrong{"[Robot]\nperiod_ms = 16.5", 2, {"[Robot] period_ms = 16.5: ", "8 to 50"}},
        Wrong{"[Robot]\ngroup = a b", 2, {"[Robot] group = a b: "}},
        Wrong{"[Robot]\ncontroller_user = a/b", 2, {"[Robot] controller_user = a/b: "}},
        Wrong{"[Robot]\nspeed = 3",
              2,
              {"[Robot] speed = 3: ", "port", "camera", "period_ms", "group", "controller_user", "absent",
               "board_model", "servo_models"}},
        Wrong{"[Offsets]\nNeck = 0.21", 2, {"[Offsets] Neck = 0.21: ", "-0.2 to 0.2 rad"}},
        Wrong{"[Offsets]\nNeck = nan", 2, {"[Offsets] Neck = nan: ", "-0.2 to 0.2 rad"}},
        Wrong{"[Offsets]\nNose = 0.1", 2, {"[Offsets] Nose = 0.1: ", "Neck"}},
        Wrong{"[Imu]\nmounting = 0, 0", 2, {"[Imu] mounting = 0, 0: ", "three numbers from -0.35 to 0.35 rad"}},
        Wrong{"[Imu]\naccel_scale = 1, 1, 0", 2, {"[Imu] accel_scale = 1, 1, 0: ", "0.8 to 1.2"}},
        Wrong{"[Imu]\ngyro_bias = 0, nan, 0", 2, {"[Imu] gyro_bias = 0, nan, 0: ", "-1 to 1 rad/s"}},
        Wrong{"[Imu]\nbias = 0, 0, 0", 2, {"[Imu] bias = 0, 0, 0: ", messages::kNoSuchImuKey}},
        Wrong{"[Safety]\nstall_ms = never", 2, {"[Safety] stall_ms = never: ", "50 to 10000 ms"}},
        Wrong{"[Limits]\nNeck = -9, 9", 2, {"[Limits] Neck = -9, 9: ", "-1.92975 to 1.69045"}},
        Wrong{"\n[Offset]", 2, {"[Offset]", "[Robot], [Safety], [Limits]", "[Offsets]"}},
        Wrong{"port = /dev/ttyUSB0", 1, {"\"port\"", "[Robot], [Safety], [Limits]", "[Offsets]"}},
        Wrong{"[Offsets]\nNeck 0.1", 2, {"\"Neck 0.1\""}}, Wrong{"[Offsets\nNeck = 0.1", 1, {" ] "}},
        Wrong{"[Offsets]\nNeck = 0.1\n[Robot]\n[offsets]\nneck = 0.1", 5, {"[offsets] neck", messages::kGivenTwice}},
        Wrong{"[Safety]\nhot = 60\nHot = 61", 3, {"[Safety] Hot", messages::kGivenTwice}}));

TEST_P(WrongRobotFile, IsRefusedWithFileLineKeyAndWhatIsAllowed) {
  const std::string error = errorIn(GetParam().text);
  EXPECT_THAT(error, StartsWith(text::where("robot.ini", GetParam().line) + ": "));
  for (const char* fact : GetParam().facts) EXPECT_THAT(error, HasSubstr(fact));
}

TEST(RobotFile, RefusesSettingsThatContradictEachOther) {
  EXPECT_THAT(errorIn("[Safety]\nbattery_low = 9"),
              AllOf(StartsWith("robot.ini, [Safety]"), HasSubstr("battery_empty"), HasSubstr("battery_low")));
}

TEST(RobotFile, TheSameKeyInTwoSectionsIsNotADuplicate) {
  EXPECT_EQ(errorIn("[Limits]\nNeck = -0.5, 0.5\n[Offsets]\nNeck = 0.1\n"), "no error");
}

TEST(FindRobotFile, TheNamedOneThenTheUsualOneThenNone) {
  const TemporaryFolder folder;
  const std::string usual = folder / "robot.ini", named = folder / "other.ini";
  EXPECT_EQ(readRobotFile(usual).path, "");
  std::ofstream{usual} << "[Robot]\nport = /dev/usual\n";
  EXPECT_EQ(readRobotFile(usual).port, "/dev/usual");
  const Environment name{"DARWINOP_ROBOT_FILE", named};
  EXPECT_THAT(errorOf([&] { static_cast<void>(readRobotFile(usual)); }),
              AllOf(HasSubstr("DARWINOP_ROBOT_FILE"), HasSubstr(named)));
  std::ofstream{named} << "[Robot]\nport = /dev/named\n";
  EXPECT_EQ(readRobotFile(usual).port, "/dev/named");
}

TEST(FindRobotFile, AFileThatCannotBeReadIsNotTakenForAbsent) {
  const TemporaryFolder folder;
  EXPECT_THAT(errorOf([&] { static_cast<void>(readRobotFile(folder / "")); }),
              AllOf(HasSubstr(folder / ""), HasSubstr(kFolderInsteadOfFile)));
}

TEST(FindRobotFile, ItsPortIsTheOneThatAnUnnamedRobotIsOn) {
  const TemporaryFolder folder;
  std::ofstream{folder / "robot.ini"} << "[Robot]\nport = " << folder / "tty"
                                      << "\n";
  const Environment file{"DARWINOP_ROBOT_FILE", folder / "robot.ini"};
  const Environment no_daemon{"DARWINOP_RUNTIME_NAME", folder / "none"};
  EXPECT_THAT(errorOf([] { static_cast<void>(readSetting("")); }), HasSubstr(folder / "tty"));
  std::ofstream{folder / "tty"};
  EXPECT_EQ(readSetting("").port, folder / "tty");
}

TEST(SafetyOn, WithoutAFileTheControllersSettingsHold) {
  safety::Config controller;
  controller.set("Safety", "max_joint_speed", "3");
  EXPECT_EQ(safetyOn(RobotFile{}, controller, "config.ini").max_joint_speed, 3);
}

TEST(SafetyOn, BothFilesCount) {
  const RobotFile robot = parseRobotFile("[Safety]\nmax_joint_speed = 2\n[Limits]\nNeck = -0.5, 1\n", "robot.ini");
  safety::Config controller;
  controller.set("Safety", "max_joint_speed", "3");
  controller.set("Limits", "Neck", "-1, 0.5");
  const safety::Config config = safetyOn(robot, controller, "config.ini");
  EXPECT_EQ(config.max_joint_speed, 2);
  EXPECT_EQ(config.range[index(Joint::kNeck)].low.value, -0.5);
  EXPECT_EQ(config.range[index(Joint::kNeck)].high.value, 0.5);
}

TEST(SafetyOn, KeepsRoomForAnOffsetSoThatTheServoStaysWithinTheTable) {
  const RobotFile robot = parseRobotFile("[Offsets]\nLegLowerR = 0.1\nNeck = -0.1\n", "robot.ini");
  const safety::Config config = safetyOn(robot, {}, "config.ini");
  config.check();
  for (const Joint joint : {Joint::kLegLowerR, Joint::kNeck, Joint::kHead}) {
    const safety::JointRange range = config.range[index(joint)];
    EXPECT_GE(robot.offsets.servoTicks(joint, range.low), row(joint).low);
    EXPECT_LE(robot.offsets.servoTicks(joint, range.high), row(joint).high);
  }
  EXPECT_EQ(robot.offsets.servoTicks(Joint::kLegLowerR, config.range[index(Joint::kLegLowerR)].high),
            row(Joint::kLegLowerR).high)
      << "and not more than needed";
}

TEST(SafetyOn, AnOffsetThatLeavesNothingOfALimitIsAnError) {
  const RobotFile robot = parseRobotFile("[Limits]\nLegLowerR = 2.2, 2.24\n[Offsets]\nLegLowerR = 0.1\n", "robot.ini");
  EXPECT_THAT(errorOf([&] { static_cast<void>(safetyOn(robot, {}, "config.ini")); }),
              AllOf(HasSubstr("robot.ini, [Offsets] LegLowerR"), HasSubstr("[Limits]"), HasSubstr("config.ini")));
}

TEST(DescribeRobotFile, NamesWhatDiffersFromAStockRobot) {
  EXPECT_EQ(describe(RobotFile{}), messages::kNoRobotFile);
  EXPECT_EQ(describe(parseRobotFile("[Safety]\nhot = 60\n[Limits]\nHead = 0, 0.3\n[Offsets]\nNeck = 0.1\n", "r.ini")),
            "r.ini: port /dev/ttyUSB0, 16 ms, 1 setting of [Safety], narrowed: Head, offsets in rad: Neck +0.0997");
}

}  // namespace
}  // namespace darwinop::connect
