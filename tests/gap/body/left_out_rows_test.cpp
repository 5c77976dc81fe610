// Rows that are lost, and limits of servos that nothing simulates.
#include <gmock/gmock.h>

#include <cmath>

#include "gap/body/edited_columns.hpp"
#include "gap/body/synthetic_robot.hpp"
#include "gap/case/body/asked_limits.hpp"
#include "gap/case/body/lost_rows.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

BodyTexts withSide(const std::function<std::string(std::string)>& edit) {
  BodyTexts texts;
  texts.logs["side.csv"] = edit(texts.logs["side.csv"]);
  return texts;
}

TEST(LostRows, WhatServosReadRightAfterSeveralIsLeftOut) {
  const BodyCase given = withSide([](const std::string& log) { return withoutRows(log, 60, 68); }).read();
  const Trajectory& neck = given.joint(2, index(Joint::kNeck));
  constexpr std::size_t kForgotten = 19;  // rows within 0.3 s
  for (std::size_t row = 0; row < neck.rows(); ++row) {
    const bool is_left_out = row >= 60 && row < 60 + kForgotten;
    EXPECT_EQ(std::isnan(neck.position_rad[row]), is_left_out) << row;
    EXPECT_EQ(std::isnan(neck.load[row]), is_left_out) << row;
  }
  EXPECT_EQ(given.logs[2].lost_rows, 8u);
  EXPECT_THAT(given.warnings, ElementsAre(AllOf(HasSubstr("side.csv: 8"), HasSubstr(messages::kRowsLost))));
}

TEST(LostRows, OneIsAGoalThatCameLate) {
  const BodyCase given = withSide([](const std::string& log) { return withoutRows(log, 60, 61); }).read();
  EXPECT_FALSE(std::isnan(given.joint(2, 0).position_rad[60]));
  EXPECT_THAT(given.warnings, ElementsAre(HasSubstr(messages::kRowsLost)));
}

TEST(LostRows, ALongHoleIsRefused) {
  EXPECT_THAT(withSide([](const std::string& log) { return withoutRows(log, 60, 85); }).error(),
              AllOf(HasSubstr("side.csv, line 62: 25 rows"), HasSubstr(messages::kLongHole)));
}

BodyTexts withLimit(const std::string& column, const std::function<std::string(std::size_t)>& limit) {
  return withSide([&](const std::string& log) { return withNewColumn(log, column, limit); });
}

TEST(AskedLimits, ATorqueLimitThatActsIsRefused) {
  const std::string column = "AnkleR.asked_torque [N m]";
  EXPECT_THAT(
      withLimit(column, [](std::size_t row) { return row < 50 ? "2.5" : "0.2"; }).error(),
      AllOf(HasSubstr("side.csv, line "), HasSubstr("AnkleR.asked_torque"), HasSubstr(messages::kTorqueLimitActs)));
  EXPECT_EQ(withLimit(column, [](std::size_t) { return "2"; }).error(), "") << "no load comes near";
}

TEST(AskedLimits, ASpeedLimitThatChangesAndActsIsRefused) {
  const std::string column = "AnkleR.asked_speed [rad/s]";
  EXPECT_THAT(
      withLimit(column, [](std::size_t row) { return row < 50 ? "0.5" : "0.6"; }).error(),
      AllOf(HasSubstr("side.csv, line "), HasSubstr("AnkleR.asked_speed"), HasSubstr(messages::kSpeedLimitChanges)));
  EXPECT_EQ(withLimit(column, [](std::size_t row) { return row < 50 ? "11" : "12"; }).error(), "")
      << "no goal is as fast";
  const BodyCase constant = withLimit(column, [](std::size_t) { return "0.5"; }).read();
  EXPECT_EQ(constant.joint(2, index(Joint::kAnkleR)).speed_limit_rad_s, 0.5) << "it is simulated";
}

}  // namespace
}  // namespace darwinop::gap
