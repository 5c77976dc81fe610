// Which of two files wins.
#include "safety/layers.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace darwinop::safety {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

struct Layers : ::testing::Test {
  Config robot, controller;
  Config both() const { return layered({robot, "robot.ini"}, {controller, "walk/config.ini"}); }
  std::string error() const {
    try {
      static_cast<void>(both());
    } catch (const std::runtime_error& wrong) {
      return wrong.what();
    }
    return "no error";
  }
};

TEST_F(Layers, WithoutAFileThatSaysSomethingTheDefaultsHold) {
  EXPECT_EQ(numbers(both()), numbers(Config{}));
}

TEST_F(Layers, ASettingThatOneFileNamesIsThatFiles) {
  robot.set("Safety", "stall_ms", "400");
  controller.set("Safety", "battery_low", "10.5");
  EXPECT_EQ(both().stall_ms, 400);
  EXPECT_EQ(both().battery_low, 10.5) << "laxer than the default, but robot.ini says nothing";
}

TEST_F(Layers, OfWhatGuardsTheRobotTheStricterWinsWhicheverFileHasIt) {
  struct Row {
    const char *key, *strict, *lax;
  };
  for (const Row row : {Row{"max_joint_speed", "5", "9"}, Row{"gentle_speed", "0.4", "0.9"}, Row{"hot", "50", "70"},
                        Row{"overheat", "70", "78"}, Row{"battery_low", "11.5", "10.5"},
                        Row{"battery_empty", "10.8", "9"}, Row{"release_button", "mode", "none"}}) {
    Config strict, lax;
    strict.set("Safety", row.key, row.strict);
    lax.set("Safety", row.key, row.lax);
    EXPECT_EQ(numbers(layered({strict, "a"}, {lax, "b"})), numbers(strict)) << row.key;
    EXPECT_EQ(numbers(layered({lax, "a"}, {strict, "b"})), numbers(strict)) << row.key;
  }
}

TEST_F(Layers, EverythingElseIsTheControllers) {
  robot.set("Safety", "on_exit", "hold");
  robot.set("Safety", "gone_s", "3");
  controller.set("Safety", "on_exit", "limp");
  controller.set("Safety", "gone_s", "30");
  EXPECT_EQ(both().on_exit, OnExit::kLimp);
  EXPECT_EQ(both().gone_s, 30);
}

TEST_F(Layers, ASettingThatIsNamedWithItsDefaultCountsAsNamed) {
  robot.set("Safety", "battery_low", "11");
  controller.set("Safety", "battery_low", "10.5");
  EXPECT_EQ(both().battery_low, 11);
}

TEST_F(Layers, LimitsAreWhatBothAllow) {
  robot.set("Limits", "Neck", "-1.0, 0.5");
  controller.set("Limits", "Neck", "-0.3, 0.9");
  const JointRange neck = both().range[index(Joint::kNeck)];
  EXPECT_EQ(neck.low.value, -0.3);
  EXPECT_EQ(neck.high.value, 0.5);
}

TEST_F(Layers, LimitsThatHaveNothingInCommonAreAnErrorThatNamesBothFiles) {
  robot.set("Limits", "Neck", "-1.0, -0.5");
  controller.set("Limits", "Neck", "-0.5, 0.9");
  EXPECT_THAT(error(), AllOf(StartsWith("[Limits] Neck: robot.ini "), HasSubstr(" -1, -0.5 "),
                             HasSubstr(" walk/config.ini "), HasSubstr(" -0.5, 0.9 rad")));
}

TEST_F(Layers, FilesThatContradictEachOtherAreAnErrorThatNamesBoth) {
  robot.set("Safety", "battery_empty", "10.8");
  controller.set("Safety", "battery_low", "10.5");
  EXPECT_THAT(error(), AllOf(StartsWith("robot.ini and walk/config.ini "), HasSubstr(": [Safety]: battery_empty "),
                             HasSubstr(" battery_low"), Not(HasSubstr(": config.ini"))));
}

TEST(StricterWins, NamesSettingsThatExist) {
  for (const StricterRow& rule : kStricterWins) {
    bool found = false;
    Config{}.visit([&](std::string_view name, const auto&...) { found = found || name == rule.name; });
    EXPECT_TRUE(found) << rule.name;
  }
}

}  // namespace
}  // namespace darwinop::safety
