// What DARWINOP_ROBOT and --robot may say.
#include "link/setting.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace darwinop::link {
namespace {

using testing::HasSubstr;

TEST(SettingText, NamesTheKindOfRobot) {
  EXPECT_EQ(readSetting("runtime").kind, Kind::kDaemon);
  EXPECT_EQ(readSetting("virtual").kind, Kind::kVirtual);
  EXPECT_EQ(readSetting("/dev/ttyUSB0").kind, Kind::kSerial);
  EXPECT_EQ(readSetting("twin").kind, Kind::kTwin);
}

TEST(SettingText, ATwinMayHaveAModelByNameOrByFile) {
  EXPECT_EQ(readSetting("twin").model, "");
  EXPECT_EQ(readSetting("twin:webots-2013").model, "webots-2013");
  const Setting by_file = readSetting("twin:models/my.ini");
  EXPECT_EQ(by_file.kind, Kind::kTwin) << "a slash makes no serial port of it";
  EXPECT_EQ(by_file.model, "models/my.ini");
}

TEST(SettingText, WhatIsNoRobotIsRefusedWithAllChoices) {
  for (const char* text : {"twins", "twin:", "Twin", "tcp://robot"}) {
    try {
      static_cast<void>(readSetting(text));
      ADD_FAILURE() << text << " is taken for a robot";
    } catch (const std::runtime_error& wrong) {
      EXPECT_THAT(wrong.what(), HasSubstr(std::string{"'"} + text + "'"));
      for (const char* choice : {"runtime", "/dev/ttyUSB0", "virtual", "twin[:MODEL]"})
        EXPECT_THAT(wrong.what(), HasSubstr(choice));
    }
  }
}

}  // namespace
}  // namespace darwinop::link
