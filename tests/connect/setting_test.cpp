// What DARWINOP_ROBOT and --robot may say.
#include "connect/setting.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace darwinop::connect {
namespace {

using testing::HasSubstr;

TEST(SettingText, NamesTheKindOfRobot) {
  EXPECT_EQ(readSetting("runtime").kind, RobotKind::kDaemon);
  EXPECT_EQ(readSetting("virtual").kind, RobotKind::kVirtual);
  EXPECT_EQ(readSetting("/dev/ttyUSB0").kind, RobotKind::kSerial);
  EXPECT_EQ(readSetting("twin").kind, RobotKind::kTwin);
}

TEST(SettingText, ATwinMayHaveAModelByNameOrByFile) {
  EXPECT_EQ(readSetting("twin").model, "");
  EXPECT_EQ(readSetting("twin:webots-2013").model, "webots-2013");
  const Setting by_file = readSetting("twin:models/my.ini");
  EXPECT_EQ(by_file.kind, RobotKind::kTwin) << "a slash makes no serial port of it";
  EXPECT_EQ(by_file.model, "models/my.ini");
}

TEST(SettingText, ARobotOverTcpHasAHostAndPerhapsAPort) {
  const Setting usual = readSetting("tcp://robot.local");
  EXPECT_EQ(usual.kind, RobotKind::kTcp);
  EXPECT_EQ(usual.server.host, "robot.local");
  EXPECT_EQ(usual.server.port, 5023);
  EXPECT_EQ(readSetting("tcp://192.168.123.1:4000").server.port, 4000);
}

TEST(SettingText, AHalfAddressIsRefusedWithAWholeOne) {
  for (const char* text : {"tcp://", "tcp://:5023", "tcp://robot:", "tcp://robot:0", "tcp://robot:70000",
                           "tcp://robot:50x", "tcp://robot/arm"}) {
    try {
      static_cast<void>(readSetting(text));
      ADD_FAILURE() << text << " is taken for a robot";
    } catch (const std::runtime_error& wrong) {
      EXPECT_THAT(wrong.what(), HasSubstr("tcp://HOST:PORT"));
    }
  }
}

TEST(SettingText, AUserIsForDarwinopRun) {
  try {
    static_cast<void>(readSetting("tcp://darwin@192.168.123.1"));
    ADD_FAILURE() << "nobody can log in";
  } catch (const std::runtime_error& wrong) {
    EXPECT_THAT(wrong.what(), HasSubstr("darwinop run --robot tcp://darwin@192.168.123.1"));
  }
}

TEST(SettingText, WhatIsNotARobotIsRefusedWithAllChoices) {
  for (const char* text : {"twins", "twin:", "Twin", "udp://robot"}) {
    try {
      static_cast<void>(readSetting(text));
      ADD_FAILURE() << text << " is taken for a robot";
    } catch (const std::runtime_error& wrong) {
      EXPECT_THAT(wrong.what(), HasSubstr(std::string{"'"} + text + "'"));
      for (const char* choice : {"runtime", "/dev/ttyUSB0", "virtual", "twin[:MODEL]", "tcp://HOST"})
        EXPECT_THAT(wrong.what(), HasSubstr(choice));
    }
  }
}

}  // namespace
}  // namespace darwinop::connect
