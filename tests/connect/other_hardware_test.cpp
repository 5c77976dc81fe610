// Every way to a robot on a serial line judges its servos and its board before it writes to them.
#include <gmock/gmock.h>

#include <array>
#include <atomic>
#include <string>

#include "connect/connect.hpp"
#include "connect/robot_file.hpp"
#include "connect/robot_set_up.hpp"
#include "core/packet.hpp"
#include "hal/cm730/not_ready.hpp"
#include "runtime/cycle.hpp"
#include "runtime/environment.hpp"
#include "safety/guard.hpp"

namespace darwinop::connect {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;

/// Writes one register of a device behind the loop's back.
void writeByte(hil::VirtualRobot& robot, std::uint8_t id, std::uint8_t address, std::uint8_t value) {
  std::array<std::uint8_t, kMaxFrame> frame{};
  robot.receive(encodeWrite(frame, id, address, std::array{value}), robot.now());
  robot.advance(robot.now() + 5ms);
}

TEST(OtherHardware, ARescueWritesNothingToAServoOfAnotherModel) {
  RobotSetUp robot{{"Neck=model:12"}};
  robot.host.withRobot([](hil::VirtualRobot& r) {
    writeByte(r, kBoardId, board::kDxlPower, 1);
    for (const Joint joint : {Joint::kNeck, Joint::kHead}) writeByte(r, row(joint).id, servo::kTorqueEnable, 1);
  });
  const OpenedBus opened = openSerialBus(robot.serial(), cm730::Purpose::kRescue);
  EXPECT_TRUE(opened.safety.left_out[index(Joint::kNeck)]);
  EXPECT_EQ(opened.safety.no_writes.count(), 1U);
  safety::Guard guard{opened.safety};
  runtime::Cycle loop{*opened.bus, guard, opened.safety.period};
  Commands last;
  last.session = 1;
  last.sequence = 1;
  last.end_of_session = true;
  last.unattended = true;
  for (int i = 0; i < 1500 && robot.byteOf(Joint::kHead, servo::kTorqueEnable) != 0; ++i) loop.run(last, {});
  EXPECT_EQ(robot.byteOf(Joint::kHead, servo::kTorqueEnable), 0) << "the others come to rest";
  EXPECT_EQ(robot.byteOf(Joint::kHead, servo::kLock), 1);
  EXPECT_EQ(robot.byteOf(Joint::kNeck, servo::kTorqueEnable), 1);
  EXPECT_EQ(robot.byteOf(Joint::kNeck, servo::kLock), 0);
}

TEST(OtherHardware, ABoardWithOneBlockLengthIsDriven) {
  RobotSetUp robot{{"one-block-length"}};
  runtime::Environment real_time{"DARWINOP_REALTIME", "if-allowed"};
  ConnectRequest request;
  request.setting = robot.host.path();
  request.warn = [](const std::string&) {};
  const auto link = connect(request);
  const std::atomic<bool> never{false};
  const int start = row(Joint::kNeck).start, wanted = start + 300;
  Commands asked;
  asked.joint[index(Joint::kNeck)].setGoal(radFromTicks(wanted));
  int reached = start;
  for (std::uint32_t cycle = 1; cycle < 1000 && reached != wanted; ++cycle) {
    link->publish(asked);
    ASSERT_TRUE(link->waitForCycle(cycle, never));
    reached = robot.goalTicks(Joint::kNeck);
  }
  EXPECT_EQ(reached, wanted);
  EXPECT_EQ(link->sensors().safety.state, State::kDriven);
}

TEST(OtherHardware, ABoardWithoutAnInstructionOfTheLoopIsRefusedByItsName) {
  const std::pair<const char*, const char*> lacks[] = {{"no-bulk-read", "BULK_READ"}, {"no-sync-write", "SYNC_WRITE"}};
  for (const auto& [setting, instruction] : lacks) {
    const RobotSetUp robot{{setting}};
    try {
      static_cast<void>(openSerialBus(robot.serial()));
      ADD_FAILURE() << setting;
    } catch (const cm730::NotReady& waited_for) {
      ADD_FAILURE() << waited_for.what();
    } catch (const std::runtime_error& refused) {
      EXPECT_THAT(refused.what(), AllOf(HasSubstr(instruction), HasSubstr("firmware 0x13")));
    }
  }
}

TEST(OtherHardware, ABoardOfAnotherModelIsRefusedUnlessRobotIniPermitsIt) {
  const RobotSetUp robot{{"model:30000"}};
  SerialRobot serial = robot.serial();
  for (const auto purpose : {cm730::Purpose::kDrive, cm730::Purpose::kRescue}) {
    try {
      static_cast<void>(openSerialBus(serial, purpose));
      ADD_FAILURE() << "opened";
    } catch (const std::runtime_error& refused) {
      EXPECT_THAT(refused.what(), HasSubstr("board_model = 30000"));
    }
  }
  serial.permitted.board_model = parseRobotFile("[Robot]\nboard_model = 30000\n", "robot.ini").permitted.board_model;
  EXPECT_TRUE(openSerialBus(serial).safety.left_out.none());
}

TEST(OtherHardware, ACm740IsDrivenAndNamed) {
  const RobotSetUp robot{{"cm-740"}};
  EXPECT_THAT(openSerialBus(robot.serial()).description, HasSubstr("CM-740"));
}

TEST(OtherHardware, AnMx64PermittedByRobotIniGetsTheTorqueLimitOfAnMx28) {
  RobotSetUp robot{{"LegLowerR=model:310"}};
  SerialRobot serial = robot.serial();
  EXPECT_THROW(static_cast<void>(openSerialBus(serial)), std::runtime_error);
  serial.permitted = parseRobotFile("[Robot]\nservo_models = MX-64\n", "robot.ini").permitted;
  const OpenedBus opened = openSerialBus(serial);
  EXPECT_TRUE(opened.safety.left_out.none());
  safety::Guard guard{opened.safety};
  runtime::Cycle loop{*opened.bus, guard, opened.safety.period};
  Commands asked;
  asked.session = 1;
  const auto limit = [&](Joint joint) {
    return robot.byteOf(joint, servo::kTorqueLimit) + 256 * robot.byteOf(joint, servo::kTorqueLimit + 1);
  };
  Sensors seen;
  for (int i = 0; i < 1500 && seen.safety.state != State::kDriven; ++i) {
    ++asked.sequence;
    loop.run(asked, {});
    seen = loop.sensors();
  }
  EXPECT_EQ(seen.safety.state, State::kDriven);
  EXPECT_EQ(limit(Joint::kLegLowerR), 426) << "2.5 of 6 N m";
  EXPECT_EQ(limit(Joint::kLegLowerL), 1023);
  EXPECT_NEAR(seen.joint[index(Joint::kLegLowerR)].torque_limit.value, kMaxTorqueNm, 0.003);
}

}  // namespace
}  // namespace darwinop::connect
