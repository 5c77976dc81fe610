// robot.ini on the way to a robot on a serial line.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "connect/connect.hpp"
#include "connect/robot_file.hpp"
#include "connect/robot_set_up.hpp"
#include "connect/serial_bus.hpp"
#include "core/conversions.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"
#include "hal/cm730/not_ready.hpp"
#include "hal/cm730/serial_port.hpp"
#include "hil-mocks/pty_host.hpp"
#include "runtime/environment.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::connect {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;

struct RobotOnAPty : ::testing::Test {
  TemporaryFolder folder;
  hil::VirtualRobot robot;
  hil::PtyHost host{robot};
  runtime::Environment file{"DARWINOP_ROBOT_FILE", folder / "robot.ini"};
  runtime::Environment real_time{"DARWINOP_REALTIME", "if-allowed"};
  std::atomic<bool> never{false};

  void write(const std::string& text) { std::ofstream{folder / "robot.ini"} << text; }
  std::unique_ptr<runtime::RobotLink> connectTo(const std::string& setting, ConnectRequest request = {}) {
    request.setting = setting;
    return connect(request);
  }
};

TEST_F(RobotOnAPty, PeriodAndOffsetsAreThoseOfTheFile) {
  write("[Robot]\nperiod_ms = 20\n[Offsets]\nNeck = 0.1\n");
  const auto link = connectTo(host.path());
  EXPECT_EQ(link->period(), 20ms);
  ASSERT_TRUE(link->waitForCycle(20, never));
  const int neck = host.withRobot([](hil::VirtualRobot& r) {
    const auto& table = r.board().servo(Joint::kNeck).table();
    return table.byte(servo::kPresentPosition) | table.byte(servo::kPresentPosition + 1) << 8;
  });
  const JointSensors seen = link->sensors().joint[index(Joint::kNeck)];
  EXPECT_NEAR(seen.position.value, radFromTicks(neck - 65).value, 2 * kRadPerTick);
}

TEST_F(RobotOnAPty, AControllersPeriodComesBeforeTheFiles) {
  write("[Robot]\nperiod_ms = 20\n");
  ConnectRequest request;
  request.period = 10ms;
  EXPECT_EQ(connectTo(host.path(), request)->period(), 10ms);
}

TEST_F(RobotOnAPty, APeriodThatIsTooLongToProtectARobotIsRefused) {
  write("[Robot]\n");
  ConnectRequest request;
  request.period = 51ms;
  try {
    static_cast<void>(connectTo(host.path(), request));
    ADD_FAILURE();
  } catch (const std::runtime_error& wrong) {
    EXPECT_THAT(wrong.what(), HasSubstr("8 to 50 ms"));
  }
}

TEST_F(RobotOnAPty, LimitsWithNothingInCommonEndTheProgramBeforeThePortIsOpened) {
  write("[Limits]\nNeck = -1, -0.5\n");
  ConnectRequest request;
  request.safety.set("Limits", "Neck", "0.5, 1");
  request.config_file = "/home/walk/config.ini";
  try {
    static_cast<void>(connectTo("/dev/ttyNOSUCHPORT", request));
    ADD_FAILURE();
  } catch (const std::runtime_error& wrong) {
    EXPECT_THAT(wrong.what(), AllOf(HasSubstr(folder / "robot.ini"), HasSubstr("/home/walk/config.ini")));
  }
}

TEST_F(RobotOnAPty, AFileWithAMistakeKeepsTheRobotStillButNotAVirtualOne) {
  write("[Offsets]\nNeck = 3\n");
  EXPECT_THROW(connectTo(host.path()), std::runtime_error);
  EXPECT_EQ(connectTo("virtual")->period(), 16ms);
}

TEST_F(RobotOnAPty, APortInUseMayComeYet) {
  const cm730::SerialPort other{host.path()};
  EXPECT_THROW(openSerialBus({host.path()}), cm730::NotReady);
}

TEST_F(RobotOnAPty, ABoardThatDoesNotAnswerMayComeYet) {
  host.withRobot([](hil::VirtualRobot& r) {
    hil::InjectedFault silence;
    silence.kind = hil::FaultKind::kStall;
    silence.at = 0s;
    silence.lasts = 60s;
    r.faults().add(silence);
  });
  EXPECT_THROW(openSerialBus({host.path()}), cm730::NotReady);
}

TEST(ServoLimits, NarrowTheLoopsLimitsOnEveryWayToARobot) {
  const RobotSetUp robot{{"Neck=cw-limit:1900", "Neck=ccw-limit:2200", "PelvR=cw-limit:1536"}};
  for (const auto purpose : {cm730::Purpose::kDrive, cm730::Purpose::kRescue}) {
    const OpenedBus opened = openSerialBus(robot.serial(), purpose);
    EXPECT_EQ(opened.safety.range[index(Joint::kNeck)].low, radFromTicks(1900));
    EXPECT_EQ(opened.safety.range[index(Joint::kNeck)].high, radFromTicks(2200));
    EXPECT_EQ(opened.safety.range[index(Joint::kPelvR)].low, radFromTicks(1536));
    EXPECT_EQ(opened.safety.range[index(Joint::kPelvR)].high, radFromTicks(row(Joint::kPelvR).high));
    EXPECT_EQ(opened.safety.range[index(Joint::kHead)].low, safety::hardRange(Joint::kHead).low);
    EXPECT_THAT(opened.warnings,
                AllOf(HasSubstr("servo 19 Neck"), HasSubstr("servo 9 PelvR"), HasSubstr("registers 6 and 8")));
  }
}

TEST(ServoLimits, AreInTheServosTicksAndTheOffsetIsTakenOff) {
  const RobotSetUp robot{{"Neck=ccw-limit:2200"}};
  SerialRobot serial = robot.serial();
  serial.offsets.set(Joint::kNeck, Rad{0.1});  // 65 ticks
  const OpenedBus opened = openSerialBus(serial);
  EXPECT_EQ(opened.safety.range[index(Joint::kNeck)].high, radFromTicks(2200 - 65));
  EXPECT_EQ(serial.offsets.servoTicks(Joint::kNeck, opened.safety.range[index(Joint::kNeck)].high), 2200);
}

TEST(ServoLimits, ThatAreWiderThanTheSettingsAreNotMentioned) {
  const RobotSetUp robot{{"Neck=ccw-limit:2200"}};
  SerialRobot serial = robot.serial();
  serial.safety.set("Limits", "Neck", "-0.2, 0.2");
  const OpenedBus opened = openSerialBus(serial);
  EXPECT_EQ(opened.safety.range[index(Joint::kNeck)].high.value, 0.2);
  EXPECT_EQ(opened.warnings.find("Neck"), std::string::npos) << opened.warnings;
}

TEST(ServoLimits, HoldForAControllerThatAsksForMore) {
  RobotSetUp robot{{"Neck=ccw-limit:2200"}};
  runtime::Environment real_time{"DARWINOP_REALTIME", "if-allowed"};
  ConnectRequest request;
  request.setting = robot.host.path();
  const auto link = connect(request);
  const std::atomic<bool> never{false};
  Commands wanted;
  wanted.joint[index(Joint::kNeck)].setGoal(Rad{1.5});
  // What the servo stores says nothing: it refuses a goal beyond its own limit, and sets an error bit.
  double highest = 0;
  std::uint8_t error_bits = 0;
  int cycles_at_limit = 0;
  for (std::uint32_t cycle = 1; cycle < 1000 && cycles_at_limit < 50; ++cycle) {
    link->publish(wanted);
    ASSERT_TRUE(link->waitForCycle(cycle, never));
    const JointSensors neck = link->sensors().joint[index(Joint::kNeck)];
    if (!std::isnan(neck.commanded.value)) highest = std::max(highest, neck.commanded.value);
    error_bits |= neck.error_bits;
    cycles_at_limit += robot.goalTicks(Joint::kNeck) >= 2190 ? 1 : 0;
  }
  EXPECT_EQ(cycles_at_limit, 50) << "the neck was driven there";
  EXPECT_LE(highest, radFromTicks(2200).value + 1e-9);
  EXPECT_EQ(error_bits, 0);
}

TEST(StartUp, AServoThatAppearsAfterTheStartIsNotDrivenBeforeTheNext) {
  const RobotSetUp robot{{"Neck=missing"}};
  const OpenedBus opened = openSerialBus(robot.serial());
  EXPECT_TRUE(opened.safety.left_out[index(Joint::kNeck)]);
  EXPECT_EQ(opened.safety.left_out.count(), 1u);
  EXPECT_THAT(opened.description, HasSubstr("not driven: Neck"));
}

TEST(StartUp, ASilentLegServoIsWaitedForUnlessRobotIniNamesIt) {
  const RobotSetUp robot{{"LegLowerR=missing"}};
  SerialRobot serial = robot.serial();
  EXPECT_THROW(openSerialBus(serial), cm730::NotReady);
  serial.safety = parseRobotFile("[Robot]\nabsent = LegLowerR\n", "robot.ini").safety;
  const OpenedBus opened = openSerialBus(serial);
  EXPECT_TRUE(opened.safety.absent[index(Joint::kLegLowerR)]);
  EXPECT_TRUE(opened.safety.left_out.none());
  EXPECT_THAT(opened.description, HasSubstr("absent: LegLowerR"));
}

TEST(StartUp, ARescueDoesWhatItCanWithASilentLegServo) {
  const RobotSetUp robot{{"LegLowerR=missing"}};
  const OpenedBus opened = openSerialBus(robot.serial(), cm730::Purpose::kRescue);
  EXPECT_TRUE(opened.safety.left_out[index(Joint::kLegLowerR)]);
}

TEST(StartUp, WhatAPersonHasToPutRightIsNotWaitedFor) {
  for (const char* setting : {"LegLowerR=wheel", "Neck=multi-turn", "Head=model:12", "FootL=firmware:20"}) {
    const RobotSetUp robot{{setting}};
    try {
      static_cast<void>(openSerialBus(robot.serial()));
      ADD_FAILURE() << setting;
    } catch (const cm730::NotReady& waited_for) {
      ADD_FAILURE() << waited_for.what();
    } catch (const std::runtime_error& refused) {
      EXPECT_THAT(refused.what(), AllOf(HasSubstr("FAIL  servo "), HasSubstr("-> "),
                                        HasSubstr("darwinop doctor --robot " + robot.serial().port)));
    }
  }
}

TEST(StartUp, ARefusedRobotThatIsStiffIsReportedAsSuch) {
  RobotSetUp robot{{"Neck=wheel"}};
  robot.host.withRobot([](hil::VirtualRobot& r) {
    r.receive(std::array<std::uint8_t, 8>{0xFF, 0xFF, 0xC8, 0x04, 0x03, 0x18, 0x01, 0x17}, r.now());  // servo power on
    r.advance(r.now() + std::chrono::milliseconds{5});
    r.receive(std::array<std::uint8_t, 8>{0xFF, 0xFF, 0x14, 0x04, 0x03, 0x18, 0x01, 0xCB},
              r.now());  // Head's torque on
    r.advance(r.now() + std::chrono::milliseconds{5});
  });
  try {
    static_cast<void>(openSerialBus(robot.serial()));
    ADD_FAILURE();
  } catch (const std::runtime_error& refused) {
    cm730::RobotFacts facts;
    facts.servo[index(Joint::kHead)].readable = facts.servo[index(Joint::kHead)].torque_on = true;
    EXPECT_THAT(refused.what(), HasSubstr(cm730::toText(cm730::underTorqueRows(facts).at(0))));
  }
}

}  // namespace
}  // namespace darwinop::connect
