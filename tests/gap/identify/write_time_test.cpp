// Goals written at some time between two reads: no log says when, and no delay below a row has a name.
#include <gtest/gtest.h>

#include "gap/identify/identification.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {
namespace {

Identification answerTo(const Hypothesis& truth, Case bench) {
  return identify(Study{measured(std::move(bench), truth, 3)});
}

Case writesBeforeItReads() {
  Case bench = smallBench();
  bench.goal_order = GoalOrder::kBeforeRead;
  return bench;
}

TEST(FreeWriteTime, OfAModelThatIsRightIsFoundAndNothingIsNamed) {
  const Case bench = writesBeforeItReads();
  Hypothesis truth = baselineOf(bench);
  for (const double before_s : {0.004, 0.012}) {
    truth.written_before_s = before_s;
    const Identification found = answerTo(truth, bench);
    EXPECT_EQ(found.verdict, Verdict::kNone);
    EXPECT_NEAR(found.model.written_before_s, before_s, 0.001);
  }
}

TEST(FreeWriteTime, OfLessThanARowLeavesALongerDelayItsName) {
  const Case bench = writesBeforeItReads();
  Hypothesis truth = withEffect(bench, "transport_delay", "delay", 0.04);
  truth.written_before_s = 0.004;
  const Identification found = answerTo(truth, bench);
  ASSERT_EQ(found.effects.size(), 1U);
  EXPECT_EQ(found.effects[0].effect->id, "transport_delay");
  const Estimate& delay = found.effects[0].estimates[0];
  EXPECT_LT(delay.low, 0.04);
  EXPECT_GT(delay.high, 0.04);
  EXPECT_GT(delay.high - delay.low, 0.6 * kRow) << "which part of the row is the host's is not known";
}

}  // namespace
}  // namespace darwinop::gap
