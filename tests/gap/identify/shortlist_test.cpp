// Which effects a roughly known servo may lack, with which of their parameters.
#include "gap/identify/shortlist.hpp"

#include <gtest/gtest.h>

#include "gap/identify/four_logs.hpp"
#include "gap/identify/rough_selection.hpp"

namespace darwinop::gap {
namespace {

/// Friction of the load; `slow`: as much again at low speed.
bool isRefined(double slow) {
  const Case bench = fourLogs();
  const twin::EffectInfo& effect = *twin::findEffect("directional_load_friction");
  Hypothesis truth = withEffect(bench, effect.id, "motor", 0.1);
  valueOf(truth.with(effect), "load") = 0.05;
  valueOf(truth.with(effect), "slow_load") = slow;
  valueOf(truth.with(effect), "slow_speed") = 0.3;
  const Case given = measured(bench, truth, 32);
  const Study study{given, fewRuns()};
  const FittedModel bare = refitWithDiscrepancy({}, baselineAlone(study, Nuisance::kFree));
  const std::vector<FittedModel> found = shortlist(bare, Screen{bare, {&effect}}, true);
  return found.size() == 1 && found.front().effects.back().refined;
}

TEST(Shortlist, FreesASecondaryParameterThatEarnsItsPlace) {
  EXPECT_TRUE(isRefined(0.45));
}

TEST(Shortlist, LeavesASecondaryParameterAloneThatIsNotNeeded) {
  EXPECT_FALSE(isRefined(0));
}

}  // namespace
}  // namespace darwinop::gap
