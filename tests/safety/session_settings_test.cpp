// [Safety] and [Limits] that travel with a session: they make the robot's own stricter for that session, and nothing
// else.
#include "safety/session_settings.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "safety/layers.hpp"
#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

constexpr std::size_t kNeck = index(Joint::kNeck);

Config narrow() {
  Config config;
  config.set("Limits", "Neck", "-0.1, 0.1");
  config.set("Safety", "max_joint_speed", "1.2");
  return config;
}

TEST(SessionSettings, HaveANumberForEverySetting) {
  EXPECT_EQ(numbers(Config{}).size(), SessionSettings::kValues);
  const SessionSettings settings = toSession(narrow());
  EXPECT_EQ(std::vector<double>(settings.numbers.begin(), settings.numbers.end()), numbers(narrow()));
}

TEST(SessionSettings, HoldAsAskedWhereTheRobotAllowsMore) {
  const Config config = tightened(Config{}, toSession(narrow()));
  EXPECT_EQ(numbers(config), numbers(narrow()));
}

TEST(SessionSettings, NeverWidenWhatTheRobotAllows) {
  const Config robot = narrow();
  Config lax;
  lax.battery_empty = 6.5;
  const Config config = tightened(robot, toSession(lax));
  EXPECT_EQ(config.range[kNeck].low, robot.range[kNeck].low);
  EXPECT_EQ(config.range[kNeck].high, robot.range[kNeck].high);
  EXPECT_EQ(config.max_joint_speed, 1.2);
  EXPECT_EQ(config.battery_empty, robot.battery_empty);
}

TEST(SessionSettings, ThatContradictEachOtherOrLeaveNothingChangeNothing) {
  SessionSettings settings = toSession(Config{});
  settings.numbers[0] = 0.5;  // max_joint_speed, under gentle_speed
  EXPECT_EQ(numbers(tightened(Config{}, settings)), numbers(Config{}));
  settings = toSession(Config{});
  settings.numbers[SessionSettings::kNumbers + 2 * kNeck] = 3.0;  // low above high
  EXPECT_EQ(numbers(tightened(Config{}, settings)), numbers(Config{}));
}

TEST(SessionSettings, WhateverNumbersComeTheRobotsGuardsHold) {
  std::mt19937_64 random{22};
  const double odd[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300, 0};
  for (int i = 0; i < 20'000; ++i) {
    SessionSettings settings;
    settings.given = 1;
    for (double& value : settings.numbers)
      value = random() % 4 == 0 ? odd[random() % 4] : std::uniform_real_distribution{-5.0, 100.0}(random);
    const Config config = tightened(narrow(), settings);
    ASSERT_NO_THROW(config.check());
    ASSERT_LE(config.max_joint_speed, narrow().max_joint_speed);
    ASSERT_LE(config.overheat, narrow().overheat);
    ASSERT_GE(config.range[kNeck].low, narrow().range[kNeck].low);
    ASSERT_LE(config.range[kNeck].high, narrow().range[kNeck].high);
  }
}

TEST(SessionSettings, HoldForTheirSessionAndNotForTheNext) {
  Rig rig;
  rig.commands.settings = toSession(narrow());
  rig.start();
  rig.joint(Joint::kNeck).setGoal(Rad{1.0});
  rig.runFor(2);
  EXPECT_NEAR(rig.robot[Joint::kNeck].position, 0.1, 0.005);
  rig.commands.settings = SessionSettings{};
  rig.start();
  rig.joint(Joint::kNeck).setGoal(Rad{1.0});
  rig.runFor(3);
  EXPECT_NEAR(rig.robot[Joint::kNeck].position, 1.0, 0.005);
}

TEST(SessionSettings, AreReadWhenTheSessionBeginsAndCannotBeLoosenedLater) {
  Rig rig;
  rig.commands.settings = toSession(narrow());
  rig.start();
  rig.commands.settings = SessionSettings{};
  rig.joint(Joint::kNeck).setGoal(Rad{1.0});
  rig.runFor(2);
  EXPECT_NEAR(rig.robot[Joint::kNeck].position, 0.1, 0.005);
}

TEST(SessionSettings, ABatteryThresholdOfTheSessionMakesItKneelEarlier) {
  Rig rig;
  Config strict;
  strict.set("Safety", "battery_empty", "11.4");
  strict.set("Safety", "battery_low", "11.6");
  rig.commands.settings = toSession(strict);
  rig.start();
  rig.robot.volt = 11.2;
  rig.runFor(2.5);
  EXPECT_TRUE(rig.active(Fault::kBatteryEmpty));
}

}  // namespace
}  // namespace darwinop::safety
