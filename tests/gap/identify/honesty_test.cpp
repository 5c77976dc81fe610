// A verdict is invariant to order, names, fresh noise and duplicates of logs, on small benches.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "gap/identify/identification.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {
namespace {

constexpr double kFriction = 0.04;  // N m

std::vector<std::string> effectsOf(const Identification& identification) {
  std::vector<std::string> ids;
  for (const IdentifiedEffect& found : identification.effects) ids.emplace_back(found.effect->id);
  return ids;
}

const Case& rubbing() {
  static const Case bench = smallBench();
  static const Case given = measured(bench, withEffect(bench, "coulomb", "friction", kFriction), 21);
  return given;
}

const Identification& namedAsItIs() {
  static const Identification identification = identify(Study{rubbing()});
  return identification;
}

const Estimate& frictionIn(const Identification& identification) {
  return identification.effects.at(0).estimates.at(0);
}

double widthOf(const Estimate& estimate) {
  return estimate.high - estimate.low;
}

TEST(Honesty, OrderNamesAndLabelsOfLogsDoNotCount) {
  Case shuffled = rubbing();
  std::rotate(shuffled.logs.begin(), shuffled.logs.begin() + 2, shuffled.logs.end());
  std::swap(shuffled.logs[0], shuffled.logs[1]);
  const std::array names{"deadband", "coulomb", "none", "backlash"};
  for (std::size_t i = 0; i < shuffled.logs.size(); ++i) {
    shuffled.logs[i].file = std::string{names[i]} + ".csv";
    shuffled.logs[i].kind = names[shuffled.logs.size() - 1 - i];
  }
  shuffled.name = shuffled.folder = shuffled.model.name = "effect_free";
  const Identification &before = namedAsItIs(), after = identify(Study{shuffled});
  EXPECT_EQ(before.verdict, Verdict::kNamed);
  EXPECT_EQ(after.verdict, before.verdict);
  ASSERT_EQ(effectsOf(after), effectsOf(before));
  // Another order of the logs draws other noise.
  EXPECT_NEAR(frictionIn(after).value, frictionIn(before).value, widthOf(frictionIn(before)));
}

TEST(Honesty, ACopyOfALogNarrowsNoInterval) {
  Case twice = rubbing();
  for (std::size_t i = 0; i < 2; ++i) {
    twice.logs.push_back(twice.logs[i]);
    twice.logs.back().file = "again_" + twice.logs[i].file;
  }
  const Case single = rubbing();
  EXPECT_EQ(evidenceOf(plantOf(twice), twice, baselineOf(twice)).logs,
            evidenceOf(plantOf(single), single, baselineOf(single)).logs);
  const Identification &once = namedAsItIs(), after = identify(Study{twice});
  ASSERT_EQ(effectsOf(after), effectsOf(once));
  EXPECT_NEAR(after.effects[0].gain, once.effects[0].gain, 0.01 * once.effects[0].gain);
  EXPECT_NEAR(widthOf(frictionIn(after)), widthOf(frictionIn(once)), 0.01 * widthOf(frictionIn(once)));
}

// At the 4 % that the issue allows, 2 of 4 would alarm once in 110 such runs: 1 - P(0) - P(1) = 0.009.
TEST(Honesty, FreshDataOfARightModelRaiseNoAlarm) {
  const char* const seed = std::getenv("DARWINOP_SEED");
  const std::uint64_t first = seed != nullptr ? std::strtoull(seed, nullptr, 10) : 4'000;
  RecordProperty("seed", std::to_string(first));
  const Case bench = smallBench();
  int alarms = 0;
  for (std::uint64_t i = 0; i < 4; ++i) {
    const Identification identification = identify(Study{measured(bench, baselineOf(bench), first + i)});
    alarms += identification.verdict == Verdict::kNone || identification.verdict == Verdict::kCannotTell ? 0 : 1;
  }
  EXPECT_LE(alarms, 1) << "DARWINOP_SEED=" << first << " shows it again";
}

}  // namespace
}  // namespace darwinop::gap
