// An arm that the model holds by friction and the joint does not: no gradient frees it.
#include "gap/identify/stuck_log.hpp"

#include <gtest/gtest.h>

#include "gap/plant/position_error.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {
namespace {

constexpr double kFriction = 0.06;  // N m, of the model

/// Three logs of a joint with less friction than the model. A release comes first: what is fitted worst is found by its
/// cost, not by its place.
Case measuredWith(double share_of_friction) {
  Case bench = smallBench();
  bench.model.effects.insert(bench.model.effects.begin(),
                             {.info = twin::findEffect("coulomb"), .values = {kFriction}, .joint = {}});
  bench.priors.push_back({"coulomb.friction", 0.1});
  bench.logs[2] = commanded(
      "release", 4, 16, 0.3, [](double) { return 0.5; }, 0.5);
  std::swap(bench.logs[0], bench.logs[2]);
  Hypothesis truth = withEffect(bench, "coulomb", "friction", share_of_friction * kFriction);
  truth.servo.kt_nm_a *= 0.98;
  truth.servo.resistance_ohm *= 0.98;
  truth.pendulum.length_m *= 0.994;
  return measured(bench, truth, 3);
}

double errorOf(const Study& study, const FittedModel& fitted) {
  return rmsPositionError(study.plant, study.data, fitted.hypothesis(), LogRole::kFit);
}

TEST(StuckLog, DoesNotHoldTheNumbersOfTheBaselineBack) {
  const Case given = measuredWith(0.85);
  const Study study{given};
  const FittedModel fitted = baselineAlone(study, Nuisance::kFree);
  EXPECT_LT(errorOf(study, fitted), 0.0015);
}

TEST(StuckLog, WhereNoLogIsWrongThereIsNothingToPass) {
  const Case given = measuredWith(1);
  const Study study{given};
  EXPECT_FALSE(fittedPastAStuckLog(baselineAlone(study, Nuisance::kFree)));
}

}  // namespace
}  // namespace darwinop::gap
