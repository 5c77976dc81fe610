// A servo that nobody has measured, on a bench where more happens than any model knows: what is named all the same.
#include "gap/identify/rough_selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "gap/case/case.hpp"
#include "gap/identify/fewer_logs.hpp"
#include "gap/identify/identification.hpp"
#include "gap/identify/rivals.hpp"
#include "gap/identify/shown.hpp"
#include "gap/identify/two_effects.hpp"
#include "gap/manual_bench.hpp"

namespace darwinop::gap {
namespace {

const IdentifiedEffect* foundIn(const Identification& identification, std::string_view id) {
  const auto there =
      std::ranges::find(identification.effects, id, [](const IdentifiedEffect& found) { return found.effect->id; });
  return there == identification.effects.end() ? nullptr : &*there;
}

bool isRival(const Identification& identification, std::string_view id) {
  return std::ranges::any_of(identification.rivals, [&](const Rival& rival) {
    return rival.isClose() && std::ranges::find(rival.effects, id) != rival.effects.end();
  });
}

std::string namesIn(const Identification& identification) {
  std::string names;
  for (const IdentifiedEffect& found : identification.effects)
    for (const Estimate& one : found.estimates) names += one.name + " = " + std::to_string(one.value) + " ";
  for (const Rival& rival : identification.rivals) {
    names += "; or";
    for (const std::string& id : rival.effects) names += " " + id;
  }
  return names;
}

// One payload: no log shows whether friction grows with the load, with its square, or more for one direction.
TEST(RoughNumbers, WhatEveryServoHasIsFoundThoughSomethingRemains) {
  const Case bench = manualBench();
  const Disturbance gusts{.torque_nm = 0.06, .torque_time_s = 0.4};  // that no model of a servo knows
  const Identification identification = identify(Study{measuredIn(gusts, bench, realServo(bench))});
  SCOPED_TRACE(namesIn(identification));
  EXPECT_EQ(identification.verdict, Verdict::kAmbiguous);
  EXPECT_TRUE(isRival(identification, "directional_load_friction") ||
              isRival(identification, "quadratic_load_friction"));
  for (const Rival& rival : identification.rivals)
    EXPECT_NE(std::ranges::find(rival.effects, "coulomb"), rival.effects.end()) << "a release shows it";
  EXPECT_TRUE(identification.remains);
  const IdentifiedEffect* const gain = foundIn(identification, "kp_scale");
  ASSERT_NE(gain, nullptr);
  EXPECT_NEAR(gain->estimates.front().value, 0.5, 0.01);
  EXPECT_LT(gain->estimates.front().low, gain->estimates.front().high);
  EXPECT_NE(foundIn(identification, "encoder_offset"), nullptr);
  EXPECT_NE(foundIn(identification, "load_dependent_friction"), nullptr);
  EXPECT_LE(identification.effects.size(), 5U) << "nothing else is missing";
  EXPECT_EQ(foundIn(identification, "supply_sag"), nullptr);
  EXPECT_LT(identification.gap_after_rad, 0.15 * identification.gap_before_rad);
}

Hypothesis slowToStart(const Case& bench) {
  Hypothesis truth = withEffect(bench, "coulomb", "friction", 0.1);
  valueOf(truth.with(*twin::findEffect("viscous")), "damping") = 0.04;
  valueOf(truth.with(*twin::findEffect("accel_limit")), "accel") = 30;
  valueOf(truth.with(*twin::findEffect("transport_delay")), "delay") = 0.03;
  return truth;
}

TEST(RoughNumbers, TwoRarerEffectsAreNamedOneAfterTheOther) {
  const Case bench = manualBench();
  const Disturbance gusts{.torque_nm = 0.06, .torque_time_s = 0.4};
  const Case given = measuredIn(gusts, bench, slowToStart(bench));
  const Study study{given};
  Case some = given;  // starts are compared on half of the logs
  for (std::size_t i = 0; i < 6; i += 2) some.logs[i].held_out = true;
  const Study few{some};
  const IdentifyOptions options;
  RoughSelection selection{study, few, options, baselineAlone(study, Nuisance::kFree)};
  selection.run();
  const Identification identification = selection.result();
  SCOPED_TRACE(namesIn(identification));
  for (const char* const id : {"coulomb", "viscous", "accel_limit", "transport_delay"})
    EXPECT_NE(foundIn(identification, id), nullptr) << id;
  EXPECT_LT(identification.gap_after_rad, 0.15 * identification.gap_before_rad);
}

constexpr Disturbance kGusts{.torque_nm = 0.06, .torque_time_s = 0.4};

Identification selected(const Case& given) {
  const Study study{given};
  const IdentifyOptions options;
  RoughSelection selection{study, study, options, baselineAlone(study, Nuisance::kFree)};
  selection.run();
  return selection.result();
}

/// Of a servo that is slow to start.
Case slowServo(std::vector<Trajectory> others) {
  const Case bench = manualBench();
  Case given = measuredIn(kGusts, bench, slowToStart(bench));
  given.others = std::move(others);
  return given;
}

/// Of the same motions with another payload.
std::vector<Trajectory> othersOf(const Hypothesis& truth, double payload_kg) {
  Case bench = manualBench();
  for (Trajectory& log : bench.logs) log.payload_kg = payload_kg, log.held_out = false;
  return measuredIn(kGusts, bench, truth).logs;
}

Hypothesis quickServo() {
  return withEffect(manualBench(), "coulomb", "friction", 0.1);
}

TEST(RoughNumbers, ValidationConfirmsWhatFittedLogsShow) {
  const Identification found = selected(slowServo(othersOf(slowToStart(manualBench()), 0.3)));
  SCOPED_TRACE(namesIn(found));
  for (const char* const id : {"coulomb", "viscous", "accel_limit", "transport_delay"})
    EXPECT_NE(foundIn(found, id), nullptr) << id;
}

TEST(RoughNumbers, ValidationRefutesWhatFittedLogsShow) {
  const Identification found = selected(slowServo(othersOf(quickServo(), 0.3)));
  SCOPED_TRACE(namesIn(found));
  EXPECT_EQ(foundIn(found, "accel_limit"), nullptr);
  EXPECT_EQ(foundIn(found, "transport_delay"), nullptr);
}

// What fitted logs repeat shares what the model lacks; what is held out must not decide.
TEST(RoughNumbers, RepeatsAndHeldOutLogsDoNotDecide) {
  std::vector<Trajectory> others = othersOf(quickServo(), 0.4), held_out = othersOf(quickServo(), 0.3);
  for (Trajectory& log : others) log.time_s[9] += 0.006;  // late: a step seems slower
  for (Trajectory& log : held_out) log.held_out = true;
  others.insert(others.end(), held_out.begin(), held_out.end());
  const Identification found = selected(slowServo(std::move(others)));
  SCOPED_TRACE(namesIn(found));
  EXPECT_NE(foundIn(found, "accel_limit"), nullptr);
  EXPECT_NE(foundIn(found, "transport_delay"), nullptr);
}

/// Two fitted logs, and `count` for validation.
Identification withValidation(std::size_t count) {
  std::vector<Trajectory> others = othersOf(slowToStart(manualBench()), 0.3);
  others.resize(count);
  Case given = slowServo(std::move(others));
  given.logs.resize(2);
  return selected(given);
}

TEST(RoughNumbers, ValidationCountsWhereFittedLogsAreTooFew) {
  EXPECT_TRUE(withValidation(0).too_few_logs);
  for (const std::size_t count : {1U, 3U}) {
    const Identification found = withValidation(count);
    SCOPED_TRACE(namesIn(found));
    EXPECT_FALSE(found.too_few_logs) << count;
    EXPECT_TRUE(foundIn(found, "accel_limit") != nullptr || isRival(found, "accel_limit")) << count;
  }
}

TEST(FewerLogs, AreAThirdOfManyAndAllOfFew) {
  Case given = smallBench();
  given = measured(given, baselineOf(given), 1);
  const Study few{given, {.runs = 2, .disturbance = {}}};
  EXPECT_EQ(&FewerLogs{few}.study(), &few);
  for (Trajectory& log : given.logs) log.held_out = false;
  while (given.logs.size() < 13) {
    given.logs.push_back(given.logs[given.logs.size() - 3]);
    given.logs.back().position_rad.front() += 1e-4;  // no copy of another
  }
  given.others = given.logs;
  const Study many{given, {.runs = 2, .disturbance = {}}};
  ASSERT_EQ(many.evidence.logs.size(), 13U);
  const FewerLogs third{many};
  EXPECT_EQ(third.study().evidence.logs, (std::vector<std::size_t>{0, 3, 6, 9, 12}));
  EXPECT_TRUE(third.study().data.others.empty());
}

TEST(RoughNumbers, AModelThatExplainsAllIsFoundAsEver) {
  const Case bench = manualBench();
  const Case given = measuredIn({}, bench, withEffect(bench, "coulomb", "friction", 0.08));
  const Identification identification = identify(Study{given});
  EXPECT_FALSE(identification.remains);
  ASSERT_EQ(identification.effects.size(), 1U);
  EXPECT_EQ(identification.effects.front().effect->id, "coulomb");
}

// One release of six logs is braked a little more, by its cable perhaps: a fit to all gains by viscous friction.
TEST(RoughNumbers, WhatNoiseExplainsGetsNoNameThatPredictsNoOtherLog) {
  const Case bench = manualBench();
  Hypothesis truth = withEffect(bench, "coulomb", "friction", 0.08);
  Case given = measuredIn({}, bench, truth);
  valueOf(truth.with(*twin::findEffect("viscous")), "damping") = 0.0015;
  given.logs[2] = measuredIn({}, bench, truth).logs[2];
  const Identification identification = identify(Study{given});
  SCOPED_TRACE(namesIn(identification));
  ASSERT_EQ(identification.effects.size(), 1U);
  EXPECT_EQ(identification.effects.front().effect->id, "coulomb");
}

TEST(RoughNumbers, AZeroErrorThatMayAsWellBeNoneIsNotNamed) {
  const Case bench = manualBench();
  Hypothesis truth = withEffect(bench, "coulomb", "friction", 0.05);
  valueOf(truth.with(*twin::findEffect("viscous")), "damping") = 0.04;
  const Identification identification =
      identify(Study{measuredIn({.torque_nm = 0.03, .torque_time_s = 0.4}, bench, truth)});
  SCOPED_TRACE(namesIn(identification));
  ASSERT_EQ(identification.effects.size(), 2U);
  EXPECT_NEAR(foundIn(identification, "coulomb")->estimates.front().value, 0.05, 0.015);
  EXPECT_NEAR(foundIn(identification, "viscous")->estimates.front().value, 0.04, 0.01);
}

Case benchOfTwelveLogs() {
  Case bench = manualBench();
  for (const double p_register : {12.0, 24.0})
    for (std::size_t i = 0; i < 3; ++i) {
      bench.logs.push_back(bench.logs[i]);
      bench.logs.back().p_register = p_register;
    }
  return bench;
}

// Of twelve logs a third is searched first, then all: each has its say in the number.
TEST(RoughNumbers, AModelThatExplainsAThirdIsFittedToAll) {
  const Case bench = benchOfTwelveLogs();
  const Case given = measuredIn({}, bench, withEffect(bench, "coulomb", "friction", 0.08));
  const Study study{given};
  ASSERT_LT(FewerLogs{study}.study().evidence.logs.size(), study.evidence.logs.size());
  const Identification all = identify(study), third = identify(FewerLogs{study}.study());
  ASSERT_EQ(all.effects.size(), 1U) << namesIn(all);
  ASSERT_EQ(third.effects.size(), 1U) << namesIn(third);
  const Estimate &one = all.effects.front().estimates.front(), &other = third.effects.front().estimates.front();
  EXPECT_NEAR(one.value, 0.08, 0.004);
  EXPECT_NE(one.value, other.value) << "the other logs have their say";
}

TEST(TwoEffects, ThatExplainAThirdOfTheLogsAreRefutedByTheOthers) {
  const Case bench = benchOfTwelveLogs();
  const Hypothesis truth = withEffect(bench, "coulomb", "friction", 0.08);
  const Disturbance gusts{.torque_nm = 0.06, .torque_time_s = 0.4};
  const Case calm = measuredIn({}, bench, truth);
  const Study of_calm{calm};
  const FewerLogs third{of_calm};
  Case given = measuredIn(gusts, bench, truth);
  for (const std::size_t log : third.study().evidence.logs) given.logs[log] = calm.logs[log];
  const IdentifyOptions options;
  EXPECT_TRUE(searchTwoEffects(third.study(), third.study(), options).explained.has_value());
  EXPECT_FALSE(searchTwoEffects(Study{given}, third.study(), options).explained.has_value());
}

bool isShown(const Case& given, std::string_view id) {
  return std::ranges::none_of(effectsNotShown(given), [&](const twin::EffectInfo* effect) { return effect->id == id; });
}

/// A joint of an arm, from a program that records goals and positions alone: one weight, one gain, held horizontally.
Case jointOfAnArm() {
  Case bench = manualBench();
  bench.logs.clear();
  for (int i = 0; i < 6; ++i) {
    bench.logs.push_back(commanded("horizontal", 5, 16, 0.4, i % 2 == 0 ? &slowWave : &quickWave));
    bench.logs.back().held_out = i > 3;
  }
  return bench;
}

Case withoutLoads(Case given) {
  for (Trajectory& log : given.logs)
    log.load = log.volt_v = std::vector<double>(log.rows(), std::numeric_limits<double>::quiet_NaN());
  return given;
}

TEST(RoughNumbers, TwoLogsAreTooFewForWhatLoadsDoNotShow) {
  Case bench = manualBench();
  for (std::size_t i = 1; i < bench.logs.size(); ++i) bench.logs[i].held_out = i != 3;
  const Disturbance gusts{.torque_nm = 0.06, .torque_time_s = 0.4};
  const Case given = measuredIn(gusts, bench, realServo(bench));
  const Identification with_loads = identify(Study{given}), without = identify(Study{withoutLoads(given)});
  ASSERT_EQ(with_loads.effects.size(), 1U) << namesIn(with_loads);
  EXPECT_EQ(with_loads.effects.front().effect->id, "kp_scale");
  EXPECT_EQ(without.verdict, Verdict::kCannotTell) << namesIn(without);
  EXPECT_TRUE(without.too_few_logs);
}

// Under a load that never changes, friction that is proportional to it is dry friction.
TEST(RoughNumbers, AKindOfFrictionThatNoLogShowsIsAmbiguous) {
  const Case bench = jointOfAnArm();
  const Disturbance gusts{.torque_nm = 0.02, .torque_time_s = 0.4};
  const Case given = withoutLoads(measuredIn(gusts, bench, withEffect(bench, "coulomb", "friction", 0.12)));
  const Identification identification = identify(Study{given});
  SCOPED_TRACE(namesIn(identification));
  EXPECT_EQ(identification.verdict, Verdict::kAmbiguous);
  for (const std::string_view kind : {"coulomb", "load_dependent_friction"})
    EXPECT_TRUE(foundIn(identification, kind) != nullptr || isRival(identification, kind)) << kind;
}

// Slow motion shows friction that is greater at rest, but no log shows dry friction itself.
TEST(RoughNumbers, ADoubleOfAnEffectThatNoLogShowsIsARival) {
  const Case bench = jointOfAnArm();
  Hypothesis truth = withEffect(bench, "stribeck", "friction", 0.2);
  valueOf(truth.with(*twin::findEffect("stribeck")), "speed") = 0.1;
  const Disturbance gusts{.torque_nm = 0.04, .torque_time_s = 0.4};
  const Case given = withoutLoads(measuredIn(gusts, bench, truth));
  ASSERT_TRUE(isShown(given, "stribeck"));
  ASSERT_FALSE(isShown(given, "coulomb"));
  const Identification identification = identify(Study{given});
  EXPECT_TRUE(foundIn(identification, "stribeck") != nullptr || isRival(identification, "stribeck"))
      << namesIn(identification);
}

// Beside a friction that grows with every load, one that grows with the motor's alone hardly gains anything.
TEST(RoughNumbers, ARicherKindOfFrictionMayReplaceTheSimpleOne) {
  Case bench = manualBench();
  for (std::size_t i = 0; i < bench.logs.size(); ++i) bench.logs[i].payload_kg = i % 2 == 0 ? 0.2 : 0.8;
  Hypothesis truth = withEffect(bench, "coulomb", "friction", 0.1);
  valueOf(truth.with(*twin::findEffect("viscous")), "damping") = 0.04;
  valueOf(truth.with(*twin::findEffect("directional_load_friction")), "motor") = 0.35;
  Case given = measuredIn({.torque_nm = 0.03, .torque_time_s = 0.4}, bench, truth);
  for (const double payload_kg : {0.3, 0.5})
    for (Trajectory& log : othersOf(truth, payload_kg)) given.others.push_back(std::move(log));
  const Identification found = selected(given);
  SCOPED_TRACE(namesIn(found));
  std::vector<std::vector<std::string>> sets(1);
  for (const IdentifiedEffect& one : found.effects) sets.front().emplace_back(one.effect->id);
  for (const Rival& rival : found.rivals) sets.push_back(rival.effects);
  EXPECT_TRUE(std::ranges::any_of(sets, [](const std::vector<std::string>& set) {
    return std::ranges::find(set, "directional_load_friction") != set.end() &&
           std::ranges::find(set, "load_dependent_friction") == set.end();
  }));
}

TEST(RoughNumbers, AnEffectAtTheEndOfItsRangeIsNotNamed) {
  const Case bench = manualBench();
  Hypothesis truth = realServo(bench);
  valueOf(truth.with(*twin::findEffect("encoder_offset")), "offset") = 0.3;  // twice what any servo has
  const Identification identification =
      identify(Study{measuredIn({.torque_nm = 0.06, .torque_time_s = 0.4}, bench, truth)});
  EXPECT_EQ(foundIn(identification, "encoder_offset"), nullptr) << namesIn(identification);
}

TEST(RoughNumbers, AnAdditionThatEndsTheFrictionIsRefused) {
  const Case bench = manualBench();
  Case given = measuredIn({}, bench, withEffect(bench, "coulomb", "friction", 0.08));
  for (std::size_t i = 0; i < given.logs.size(); ++i) given.logs[i].held_out = i % 2 == 1;
  const Study study{given, {.runs = 4, .disturbance = {}}};
  const IdentifyOptions options;
  const FittedModel bare = baselineAlone(study, Nuisance::kFree);
  const twin::EffectInfo &friction = *twin::findEffect("coulomb"), &scale = *twin::findEffect("kp_scale");
  RoughSelection selection{study, study, options, refit(bare, {{&friction}}, 1)};
  FittedModel with = refitWithDiscrepancy({{&friction}, {&scale}}, selection.model());
  const auto& unknowns = with.problem.unknowns();
  const auto dry = std::ranges::find(unknowns, "coulomb.friction", &Unknown::name);
  ASSERT_NE(dry, unknowns.end());
  with.fit.x[dry - unknowns.begin()] = dry->toSearch(dry->high);
  EXPECT_FALSE(selection.accept(std::move(with)));
  EXPECT_EQ(idsOf(selection.model().effects), std::vector<std::string>{"coulomb"});
  EXPECT_NEAR(valueOf(*selection.model().hypothesis().find("coulomb"), "friction"), 0.08, 0.02);
}

TEST(Rivals, StayUndecidedBesideWhatIsAddedUntilTheyAreTestedAgain) {
  std::vector<Rival> rivals{{{"coulomb", "torque_limit"}, 0}, {{"coulomb", "quadratic_load_friction"}, 0}};
  carryOn(rivals, {"quadratic_load_friction", "transport_delay"}, "transport_delay");
  ASSERT_EQ(rivals.size(), 1U);
  EXPECT_EQ(rivals.front().effects, (std::vector<std::string>{"transport_delay", "coulomb", "torque_limit"}));
  carryOn(rivals, {}, "");
  EXPECT_EQ(rivals.front().effects.size(), 3U);
  carryOn(rivals, {"torque_limit"}, "");
  EXPECT_TRUE(rivals.empty());
}

}  // namespace
}  // namespace darwinop::gap
