// robot.ini on the way to a robot on a serial line.
#include <gmock/gmock.h>

#include <fstream>

#include "core/conversions.hpp"
#include "hal/cm730/not_ready.hpp"
#include "hal/cm730/serial_port.hpp"
#include "hil-mocks/pty_host.hpp"
#include "link/connect.hpp"
#include "link/robot_file.hpp"
#include "runtime/environment.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::link {
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
  std::unique_ptr<runtime::RobotLink> connectTo(const std::string& setting, Request request = {}) {
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
  Request request;
  request.period = 10ms;
  EXPECT_EQ(connectTo(host.path(), request)->period(), 10ms);
}

TEST_F(RobotOnAPty, LimitsWithNothingInCommonEndTheProgramBeforeThePortIsOpened) {
  write("[Limits]\nNeck = -1, -0.5\n");
  Request request;
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
  EXPECT_THROW(openSerialBus(host.path(), 16ms), cm730::NotReady);
}

TEST_F(RobotOnAPty, ABoardThatDoesNotAnswerMayComeYet) {
  host.withRobot([](hil::VirtualRobot& r) {
    hil::Fault silence;
    silence.kind = hil::FaultKind::kStall;
    silence.at = 0s;
    silence.lasts = 60s;
    r.faults().add(silence);
  });
  EXPECT_THROW(openSerialBus(host.path(), 16ms), cm730::NotReady);
}

}  // namespace
}  // namespace darwinop::link
