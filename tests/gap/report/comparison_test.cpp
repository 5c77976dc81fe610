// Position errors before and after, over the logs that count.
#include "gap/report/comparison.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace darwinop::gap
