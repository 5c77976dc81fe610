// Loads that contradict the motion.
#include <gmock/gmock.h>

#include <cmath>

#include "gap/case/case_texts.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

using testing::HasSubstr;

/// An arm that a servo of a high gain cannot lift, under full duty all the time.
CaseTexts saturated(double load_pct) {
  std::vector<CsvRow> rows = sineRows(0.05, 0.5);
  for (CsvRow& row : rows) {
    row.goal = row.t < 1.6 ? 0.5 : -0.5;
    row.load = row.t <= 1.6 ? load_pct : -load_pct;
  }
  return CaseTexts{}.with(rows).with("\"kp\": 32", "\"kp\": 128");
}

TEST(LoadErrors, ALoadWithTheOppositeSign) {
  EXPECT_EQ(saturated(100).error(), "");
  EXPECT_THAT(saturated(-100).error(), HasSubstr(messages::kLoadHasOppositeSign));
}

TEST(LoadErrors, TheOppositeSignShowsWithAGainThatIsOffByTwo) {
  EXPECT_THAT(saturated(-50).error(), HasSubstr(messages::kLoadHasOppositeSign));
}

TEST(LoadErrors, ALoadInAnotherUnitIsNotMeasured) {
  const auto with = [](double factor) {
    std::vector<CsvRow> rows = sineRows();
    for (CsvRow& row : rows) row.pos *= 0.9, row.load *= factor;
    return CaseTexts{}.with(rows).read();
  };
  for (const double factor : {0.01, 0.1}) {
    const Case read = with(factor);
    EXPECT_TRUE(std::isnan(read.logs[0].load[100])) << factor;
    EXPECT_THAT(read.warnings, testing::Contains(HasSubstr(messages::kLoadHasOtherScale))) << factor;
  }
  for (const double factor : {0.5, 1.0, 2.0}) EXPECT_FALSE(std::isnan(with(factor).logs[0].load[100])) << factor;
}

TEST(LoadErrors, ALoadOfZeroWhereTorqueIsAskedForIsNotMeasured) {
  const auto zeroes = [](double late, double on, double first = 0) {
    std::vector<CsvRow> rows = sineRows();
    for (CsvRow& row : rows) row.pos *= late, row.on = on, row.load = 0;
    rows[0].load = first;
    return CaseTexts{}.with(rows).read();
  };
  const Case pushing = zeroes(0.8, 1);
  EXPECT_TRUE(std::isnan(pushing.logs[0].load[100]));
  EXPECT_THAT(pushing.warnings, testing::Contains(HasSubstr(messages::kLoadIsZero)));
  EXPECT_EQ(zeroes(0.99, 1).logs[0].load[100], 0) << "within a dead band";
  EXPECT_EQ(zeroes(0.8, 0).logs[0].load[100], 0) << "torque is off";
  EXPECT_EQ(zeroes(0.8, 1, 5).logs[0].load[100], 0) << "not in every row";
}

}  // namespace
}  // namespace darwinop::gap
