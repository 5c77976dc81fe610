// Noise floor, places, regions, and their texts.
#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "gap/case/repeat_spread.hpp"
#include "gap/localize/localization.hpp"
#include "gap/localize/localize_case.hpp"

namespace darwinop::gap {
namespace {

const NoiseOptions kFewRuns{.runs = 12, .disturbance = {}, .seed = 1};

Localization whereIs(const Case& given) {
  return localize(Study{given, kFewRuns});
}

NoiseFloor floorFor(const Case& given) {
  const Study study{given, kFewRuns};
  return floorOf(given, study.evidence, simulateRepeats(study.plant, given, study.evidence.logs, study.baseline));
}

TEST(Floor, AgreesWithRepeatsThatDifferAsAssumed) {
  const NoiseFloor floor = floorFor(measuredCase({}));
  EXPECT_FALSE(floor.assumed);
  EXPECT_NEAR(floor.factor, 1, 0.3);
  EXPECT_TRUE(std::isnan(floor.logs[1].repeats_rad)) << "the sine has no repeat";
  EXPECT_GT(floor.logs[3].repeats_rad, 0);
  EXPECT_EQ(floor.logs[0].repeats_rad, floor.logs[3].repeats_rad) << "one motion, one spread";
  for (const LogFloor& log : floor.logs) EXPECT_GE(log.rms_rad, log.quantisation_rad);
  EXPECT_GT(floor.logs[2].rms_rad, floor.logs[0].rms_rad) << "a released arm differs more from run to run";
}

TEST(Floor, ReportsTheRatioOfRepeatsToTheAssumedNoise) {
  const NoiseFloor floor = floorFor(measuredCase({}, twin::Law::kVoltageP, 5, {.torque_nm = 0.03}));
  EXPECT_GT(floor.factor, 2);
}

// The arm is lighter than the case says even without any weight: a number known to a half would have to be negative.
TEST(Blocks, WithAWidePriorKeepNumbersPositive) {
  Case given = commandedCase();
  Case truth = given;
  truth.pendulum.arm_mass_kg = 0;
  for (Trajectory& log : truth.logs) log.payload_kg = 0.01;
  for (std::size_t i = 0; i < given.logs.size(); ++i) {
    Trace trace;
    rollOut(truth, i, baselineOf(truth), {}, trace);
    given.logs[i] = asReported(given.logs[i], trace, given.model.servo.ticks_per_rev, i);
  }
  given.pendulum.arm_mass_kg = 0.3;
  given.priors = {{"payload", 0.5}};
  EXPECT_NO_THROW((void)whereIs(given));
}

// A third run, after which the bench shook three times as much.
TEST(Floor, TakesAllRepeats) {
  Case given = measuredCase({});
  given.logs.push_back(measuredCase({}, twin::Law::kVoltageP, 9, {.torque_nm = 0.03}).logs[3]);
  given.logs.back().file = "again.csv";
  const NoiseFloor two = floorFor(measuredCase({})), three = floorFor(given);
  EXPECT_GT(three.factor, 1.2 * two.factor);
  EXPECT_GT(three.repeats_rad, 1.2 * two.repeats_rad);
  EXPECT_DOUBLE_EQ(three.repeats_rad, repeatSpread(given).rms_rad());
  EXPECT_EQ(three.logs[0].repeats_rad, three.logs[4].repeats_rad) << "one spread for each motion";
}

TEST(Floor, IsAssumedWithoutRepeats) {
  Case given = measuredCase({});
  given.logs[3].repeat_of.reset();
  EXPECT_TRUE(floorFor(given).assumed);
  given = measuredCase({});
  given.logs[3].position_rad = given.logs[0].position_rad;  // a copy of the file
  EXPECT_TRUE(floorFor(given).assumed);
}

TEST(Places, FindAPushWhereItWas) {
  Case given = measuredCase({});
  Trajectory& log = given.logs[1];
  for (std::size_t row = 0; row < log.rows(); ++row)
    if (log.time_s[row] >= 1.5 && log.time_s[row] < 1.7) log.position_rad[row] += 0.02;
  const Localization where = whereIs(given);
  ASSERT_FALSE(where.places.empty());
  const GapInterval& first = where.places.front();
  EXPECT_EQ(first.file, "sine.csv");
  EXPECT_EQ(first.signal, "position");
  EXPECT_EQ(first.joint, "");
  EXPECT_NEAR(first.t0_s, 1.5, 0.06);
  EXPECT_NEAR(first.t1_s, 1.7, 0.06);
  EXPECT_NEAR(first.size, 20, 5);
  EXPECT_EQ(first.unit, "mrad");
  for (const GapInterval& place : where.places)  // one in a hundred may be false, and is weak
    EXPECT_TRUE(place.file == "sine.csv" || place.score() < 0.2 * first.score()) << place.file << " " << place.t0_s;
}

TEST(Places, AreNoneInNoise) {
  for (const std::uint64_t seed : {3u, 4u}) {
    const Localization where = whereIs(measuredCase({}, twin::Law::kVoltageP, seed));
    EXPECT_THAT(where.places, testing::IsEmpty());
    EXPECT_FALSE(where.blocks.first);
    EXPECT_EQ(where.dependence.on, Depends::kNothing);
    EXPECT_GT(where.floors(), 0.5);  // too good would also be a finding
    EXPECT_LT(where.floors(), 1.5);
  }
}

TEST(Places, OfATorqueLimitAreAtFullLoad) {
  const Localization where = whereIs(measuredCase({"torque_limit", {0.5, 10}}));
  ASSERT_FALSE(where.places.empty());
  EXPECT_EQ(where.places.front().file == "steps.csv" || where.places.front().file == "again.csv", true);
  EXPECT_EQ(where.places.front().happens, "step");
  EXPECT_EQ(where.places.front().block, Block::kController);
  EXPECT_TRUE(std::ranges::any_of(where.places, [](const GapInterval& place) { return place.signal == "load"; }));
}

TEST(Scan, FindsNothingInWhiteNoiseAndWhatStandsOut) {
  std::mt19937_64 random{9};
  std::normal_distribution<double> normal;
  Eigen::VectorXd z(400);
  std::vector<double> time_s;
  for (Eigen::Index i = 0; i < z.size(); ++i) z[i] = normal(random), time_s.push_back(0.016 * static_cast<double>(i));
  EXPECT_THAT(scanEnergy({z}, {time_s}).front(), testing::IsEmpty());
  z.segment(100, 20).array() += 3;
  const auto found = scanEnergy({z}, {time_s}).front();
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(static_cast<double>(found.front().first), 100, 8);
  EXPECT_NEAR(static_cast<double>(found.front().last), 119, 8);
}

TEST(Dependence, OfAnOffsetIsOnTheState) {
  const Localization state = whereIs(measuredCase({"encoder_offset", {0.08}}));
  EXPECT_GT(state.dependence.by_state, 2 * state.dependence.by_clock);
}

TEST(Dependence, OfWhatChangesFromRunToRunIsOnTheClock) {
  // Nothing but the repeat, ten seconds later, has another friction.
  Case given = measuredCase({});
  const Case worn = measuredCase({"coulomb", {0.2}});
  given.logs[3] = worn.logs[3];
  const Localization clock = whereIs(given);
  EXPECT_GT(clock.dependence.by_clock, 0.1);
  EXPECT_TRUE(clock.dependence.on == Depends::kClock || clock.dependence.on == Depends::kBoth);
  EXPECT_EQ(clock.dependence.regions.front().variable, kSessionTime);
  // Without the session's clock all logs begin at once, and time within a log does not count as one.
  for (Trajectory& log : given.logs) log.is_session_known = false, log.session_start_s = 0;
  const Dependence without = whereIs(given).dependence;
  EXPECT_FALSE(without.is_clock_known);
  EXPECT_EQ(without.by_clock, 0);
  EXPECT_NE(without.regions.front().variable, kSessionTime);
}

TEST(Localization, FitsATerminalAndIsWholeInJson) {
  const Localization where = whereIs(measuredCase({"coulomb", {0.15}}));
  const std::string text = asText(where);
  EXPECT_LE(std::ranges::count(text, '\n'), 25);
  EXPECT_THAT(text, testing::HasSubstr("look at the plant first"));
  EXPECT_THAT(text, testing::HasSubstr("Floor "));
  const auto json = asJson(where);
  EXPECT_EQ(json["first_block"], "plant");
  EXPECT_EQ(json["blocks"].size(), kBlocks);
  EXPECT_EQ(json["logs"].size(), 4u);
  EXPECT_TRUE(json["logs"][1]["repeats_mrad"].is_null()) << "missing is not 0";
  EXPECT_EQ(json["places"].size(), where.places.size());
}

TEST(Localization, IsTheSameForTheSameData) {
  const Case given = measuredCase({"coulomb", {0.15}}, twin::Law::kSpeedP);
  EXPECT_EQ(asJson(whereIs(given)), asJson(whereIs(given)));
}

}  // namespace
}  // namespace darwinop::gap
