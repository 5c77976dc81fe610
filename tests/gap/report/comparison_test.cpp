// Position errors before and after, over the logs that count.
#include "gap/report/comparison.hpp"

#include <gtest/gtest.h>

#include "gap/report/report.hpp"
#include "gap/report/results.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {
namespace {

TEST(Comparison, CopiesOfALogCountOnce) {
  const Case bench = smallBench();
  Case given = measured(bench, withEffect(bench, "coulomb", "friction", 0.08), 3);
  given.logs.push_back(
      measured(bench, withEffect(bench, "coulomb", "friction", 0.04), 4).logs[3]);  // a second one that is held out
  const Hypothesis before = baselineOf(given), after = withEffect(bench, "coulomb", "friction", 0.08);
  const Comparison once = compare(given, before, after);
  given.logs.push_back(given.logs[3]);
  given.others = {given.logs[0], given.logs[3], given.logs[4]};
  for (double& goal : given.others.back().goal_rad) goal += 0.01;  // another log
  const Comparison twice = compare(given, before, after);
  EXPECT_EQ(once.held_out_logs, 2U);
  EXPECT_EQ(twice.held_out_logs, 2U);
  EXPECT_DOUBLE_EQ(twice.held_out.before_rad, once.held_out.before_rad);
  EXPECT_DOUBLE_EQ(twice.held_out.after_rad, once.held_out.after_rad);
  EXPECT_EQ(twice.logs.size(), 6U) << "each is shown";
  EXPECT_EQ(twice.other_logs, 1U);
  EXPECT_GT(twice.others.before_rad, 0);
}

// Else the model that a run has found is compared with another time of the write than the run had.
TEST(Comparison, OfModelFilesFindsWhenGoalsWereWritten) {
  Case bench = smallBench();
  bench.goal_order = GoalOrder::kBeforeRead;
  Hypothesis truth = baselineOf(bench);
  truth.written_before_s = 0.002;
  const Case given = measured(bench, truth, 3);
  const Report report = reportOn(given, caseModel(given), caseModel(given));
  EXPECT_LT(report.comparison.fit.floorsAfter(), 1.1);
  EXPECT_GT(compare(given, baselineOf(given), baselineOf(given)).fit.floorsAfter(), 1.3) << "half a row";
}

// An arm that falls to the other side in one of a thousand logs is most of their rms error.
TEST(Comparison, OfTheOtherLogsHasTheWorstAndTheOneInTheMiddle) {
  const Case bench = smallBench();
  Case given = measured(bench, baselineOf(bench), 3);
  EXPECT_TRUE(std::isnan(compare(given, baselineOf(given), baselineOf(given)).worst_other_rad));
  const double shifts_rad[] = {0.02, 0.3, 0.01};
  for (const double shift_rad : shifts_rad) {
    given.others.push_back(given.logs[0]);
    given.others.back().file = std::to_string(shift_rad);
    for (double& position : given.others.back().position_rad) position += shift_rad;
  }
  const Comparison found = compare(given, baselineOf(given), baselineOf(given));
  EXPECT_EQ(found.worst_other, std::to_string(0.3));
  EXPECT_NEAR(found.worst_other_rad, 0.3, 0.01);
  EXPECT_NEAR(found.median_other_rad, 0.02, 0.01);
  EXPECT_GT(found.others.after_rad, 0.15);
  EXPECT_NE(asText(given, found).find("worst: 300 in " + found.worst_other), std::string::npos) << asText(given, found);
}

}  // namespace
}  // namespace darwinop::gap
