// Settings of robot.ini for the rescue.
#include "supervisor/robot_settings.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "connect/robot_file.hpp"
#include "runtime/environment.hpp"
#include "supervisor/messages.hpp"
#include "support/temporary_folder.hpp"
#include "support/usb_tree.hpp"

namespace darwinop::supervisor {
namespace {

RobotSettings settingsOf(const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = folder / "robot.ini";
  std::ofstream{path} << text;
  runtime::Environment file{"DARWINOP_ROBOT_FILE", path};
  return readRobotSettings();
}

TEST(RobotSettings, AreThoseOfTheRobotFile) {
  const RobotSettings settings =
      settingsOf("[Robot]\nport = /tmp/no-robot\nperiod_ms = 8\nabsent = Neck\n[Offsets]\nHead = 0.1\n");
  EXPECT_EQ(settings.serial.port, "/tmp/no-robot");
  EXPECT_EQ(settings.serial.period, Nanos{8'000'000});
  EXPECT_TRUE(settings.serial.safety.absent[index(Joint::kNeck)]);
  EXPECT_EQ(settings.serial.offsets.servoTicks(Joint::kHead, Rad{0}), kTickCentre + 65);
  EXPECT_FALSE(settings.identity.has_value()) << "no USB device";
}

TEST(RobotSettings, HaveTheIdentityOfAPortThatCameLater) {
  UsbTree sys;
  RobotSettings settings = settingsOf("[Robot]\nport = /tmp/ttyUSB0\n");
  noteIdentity(settings, sys.root());
  EXPECT_FALSE(settings.identity.has_value());
  sys.plug("ttyUSB0", "0403", "A900");
  noteIdentity(settings, sys.root());
  const cm730::UsbIdentity adapter{"0403", "6001", "A900"};
  EXPECT_EQ(settings.identity, adapter);
  sys.unplug("ttyUSB0");
  noteIdentity(settings, sys.root());
  EXPECT_EQ(settings.identity, adapter) << "it may come back";
}

TEST(Rescue, OpensNoPortThatIsAnotherDeviceByNow) {
  const TemporaryFolder folder;
  RobotSettings settings = settingsOf("[Robot]\nport = /dev/null\n");
  settings.identity = cm730::UsbIdentity{"0403", "6001", "A900"};
  Rescue rescue{settings, runtime::RuntimeFiles{folder / "runtime"}, false};
  EXPECT_EQ(rescue.update(Nanos{1}), Rescue::Step::kOpening);
  EXPECT_EQ(rescue.obstacle(), std::string{"/dev/null"} + messages::kUnplugged);
}

TEST(RobotSettings, DefaultToAStockRobot) {
  const RobotSettings settings = settingsOf("[Robot]\n");
  EXPECT_EQ(settings.serial.port, connect::kRobotsPort);
  EXPECT_EQ(settings.serial.period, connect::kUsualPeriod);
}

}  // namespace
}  // namespace darwinop::supervisor
