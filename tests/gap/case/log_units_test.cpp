// Degrees in place of radians are detected, and radians are accepted.
#include <gmock/gmock.h>

#include "gap/case/case_texts.hpp"
#include "gap/case/data_check.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kDegrees = 180 / kPi;

std::vector<CsvRow> inDegrees(std::vector<CsvRow> rows) {
  for (CsvRow& row : rows) row.goal *= kDegrees, row.pos *= kDegrees;
  return rows;
}

TEST(LogUnits, LargeMotionsInDegreesAreMoreThanTwoTurns) {
  EXPECT_EQ(CaseTexts{}.with(sineRows(0.5)).error(), "");
  EXPECT_THAT(CaseTexts{}.with(inDegrees(sineRows(0.5))).error(),
              AllOf(HasSubstr(messages::kOutsideServoRange), HasSubstr("goal_deg")));
}

TEST(LogUnits, QuickSmallMotionsInDegreesAreTooFast) {
  // 0.2 rad at 1 Hz: 1.3 rad/s; as degrees 72, ten times what the servo can do.
  EXPECT_EQ(CaseTexts{}.with(sineRows(0.2, 1)).error(), "");
  EXPECT_THAT(CaseTexts{}.with(inDegrees(sineRows(0.2, 1))).error(),
              AllOf(StartsWith("my/fit_1.csv, line "), HasSubstr(messages::kTooFastForServo), HasSubstr("pos_deg")));
}

TEST(LogUnits, TooFastIsJudgedByTheSupplyOfTheLog) {
  const CaseTexts at_12 = CaseTexts{}.with(inDegrees(sineRows(0.2, 1)));
  EXPECT_THAT(at_12.error(), HasSubstr(messages::kTooFastForServo + std::string{"6.67"}));
  EXPECT_THAT(at_12.with("\"payload_kg\": 0.3", "\"payload_kg\": 0.3, \"supply_V\": 24").error(),
              HasSubstr(messages::kTooFastForServo + std::string{"13.3"}));
}

TEST(LogUnits, SlowSmallMotionsInDegreesHaveTheStepsOfDegrees) {
  EXPECT_EQ(CaseTexts{}.with(sineRows(0.05, 0.3)).error(), "");
  std::vector<CsvRow> rows = inDegrees(sineRows(0.05, 0.3));
  for (CsvRow& row : rows) row.speed *= kDegrees;
  EXPECT_THAT(CaseTexts{}.with(rows).error(), HasSubstr("pos goes in steps of 0.0879"));
}

TEST(LogUnits, OneOfGoalAndPositionInDegrees) {
  std::vector<CsvRow> rows = sineRows(0.2);
  for (CsvRow& row : rows) row.goal *= kDegrees;
  EXPECT_THAT(CaseTexts{}.with(rows).error(), HasSubstr(messages::kOneInDegrees + std::string{"goal_deg"}));
  rows = sineRows(0.2, 0.3);
  for (CsvRow& row : rows) row.pos *= kDegrees;
  EXPECT_THAT(CaseTexts{}.with(rows).error(), HasSubstr(messages::kOneInDegrees + std::string{"pos_deg"}));
}

TEST(LogUnits, SpeedInRpm) {
  std::vector<CsvRow> rows = sineRows();
  for (CsvRow& row : rows) row.speed *= 3;  // a bad estimate, but a speed
  EXPECT_EQ(CaseTexts{}.with(rows).error(), "");
  for (CsvRow& row : rows) row.speed *= 30 / kPi / 3;
  EXPECT_THAT(CaseTexts{}.with(rows).error(), HasSubstr("speed is 9.54 times as fast as pos moves"));
}

TEST(LogUnits, ManyWildReadings) {
  std::vector<CsvRow> rows = sineRows();
  rows[60].pos += 2;
  EXPECT_EQ(CaseTexts{}.with(rows).error(), "");  // one is masked
  rows = sineRows();
  for (std::size_t i = 60; i < 120; i += 2) rows[i].pos += 2;
  EXPECT_THAT(CaseTexts{}.with(rows).error(), HasSubstr(messages::kTooFastForServo));
}

TEST(LogUnits, PositionsOffTheStepsOfTheEncoderAreOdd) {
  std::vector<CsvRow> rows = sineRows();
  for (CsvRow& row : rows) row.pos += 0.0005;  // another zero is no matter
  EXPECT_TRUE(CaseTexts{}.with(rows).read().warnings.empty());
  for (CsvRow& row : rows) row.pos += 0.01 * row.goal;
  const Case c = CaseTexts{}.with(rows).read();
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_THAT(c.warnings[0], HasSubstr("my/fit_1.csv: pos does not go in steps of the encoder (0.00153 rad)"));
  EXPECT_TRUE(CaseTexts{}
                  .with(rows)
                  .with("\"firmware_dt_s\": 0.001", "\"firmware_dt_s\": 0.001, \"position_in_ticks\": false")
                  .read()
                  .warnings.empty());
}

std::vector<CsvRow> scaled(std::vector<CsvRow> rows, double factor, double last_decimal) {
  for (CsvRow& row : rows) {
    row.goal = rounded(row.goal * factor, last_decimal), row.pos = rounded(row.pos * factor, last_decimal);
    row.speed *= factor;
  }
  return rows;
}

// The jaw of an arm: 0 to 1 of 2.36 rad, rounded to 0.0001.
TEST(LogUnits, AShareOfARangeHasStepsOfItsOwn) {
  const Case c = CaseTexts{}.with(scaled(sineRows(), 1 / 2.36, 1e-4)).read();
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_THAT(c.warnings[0],
              AllOf(StartsWith("my/fit_1.csv: pos does not go in steps of the encoder (0.00153 rad) but of "
                               "0.00065"),
                    HasSubstr(messages::kOtherSteps)));
}

TEST(LogUnits, TheLastDecimalOfAFilteredLogIsNotAStep) {
  const Case c = CaseTexts{}.with(scaled(sineRows(), 0.77, 1e-3)).read();
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_THAT(c.warnings[0], HasSubstr("filtered"));
}

TEST(LogUnits, PositionsInTurns) {
  EXPECT_THAT(CaseTexts{}.with(scaled(sineRows(), 0.5 / kPi, 1e-7)).error(),
              AllOf(StartsWith("my/fit_1.csv: pos goes in steps of 0.000244"), HasSubstr(messages::kStepsOfTurns)));
}

}  // namespace
}  // namespace darwinop::gap
