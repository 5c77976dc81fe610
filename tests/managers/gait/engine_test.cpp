// The engine against the reference, tick for tick, and how it starts and stops.
#include "managers/gait/engine.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "managers/gait/golden.hpp"

namespace darwinop::gait {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Tilt kUnseen{kNaN, kNaN};
constexpr int kCallsPerPeriod = 75;  // of 600 ms

struct Scenario {
  const char* name;
  Wish wish;
  Tilt tilt;
  bool shipped_file;
  int stop_before;  // call; -1: never
};

// Source: the reference, section 13. An amplitude of 0.4 is 16 mm there.
const Scenario kScenarios[] = {
    {"G1_inplace", {0, 0, 0, false}, kUnseen, true, -1},
    {"G2_forward", {1, 0, 0, false}, kUnseen, true, -1},
    {"G3_left", {0, 1, 0, false}, kUnseen, true, -1},
    {"G4_turn", {0, 0, 0.5, false}, kUnseen, true, -1},
    {"G5_mix_aim", {0.5, -0.4, -0.3, true}, kUnseen, true, -1},
    {"G6_forward_balance", {1, 0, 0, false}, {20, -15}, false, -1},
    {"G7_forward_stop100", {1, 0, 0, false}, kUnseen, true, 100},
};

TEST(GaitEngine, IsTheReferenceTickForTick) {
  const std::vector<GoldenCall> golden = goldenCalls();
  std::size_t compared = 0;
  for (const Scenario& scenario : kScenarios) {
    Engine engine{scenario.shipped_file ? shipped() : Parameters{}};
    engine.start();
    int call = 0;
    for (const GoldenCall& expected : golden) {
      if (expected.scenario != scenario.name) continue;
      if (call == scenario.stop_before) engine.stop();
      ASSERT_EQ(expected.call, call);
      ASSERT_EQ(engine.next(scenario.wish, scenario.tilt).tick, expected.tick) << scenario.name << " call " << call;
      ASSERT_EQ(engine.running(), expected.running_after) << scenario.name << " call " << call;
      ++call;
      ++compared;
    }
    EXPECT_EQ(call, 225) << scenario.name;
  }
  EXPECT_EQ(compared, golden.size());
}

/// Greatest difference that the flaw makes at these joints in three periods, ticks.
int flawAt(Joint right, Joint left, const Wish& wish) {
  Parameters flawed = shipped(), exact = shipped();
  exact.ik = Ik::kExact;
  Engine one{flawed}, other{exact};
  one.start();
  other.start();
  int greatest = 0;
  for (int call = 0; call < 3 * kCallsPerPeriod; ++call) {
    const Goals a = one.next(wish, kUnseen), b = other.next(wish, kUnseen);
    greatest = std::max({greatest, std::abs(a[right] - b[right]), std::abs(a[left] - b[left])});
  }
  return greatest;
}

TEST(GaitEngine, TheFlawIsAsLargeAsTheReferenceSays) {
  EXPECT_EQ(flawAt(Joint::kPelvR, Joint::kPelvL, {1, 0, 0, false}), 53);
  EXPECT_EQ(flawAt(Joint::kPelvR, Joint::kPelvL, {0, 1, 0, false}), 111);
  EXPECT_EQ(flawAt(Joint::kPelvYR, Joint::kPelvYL, {0, 0, 0.5, false}), 143);
  EXPECT_EQ(flawAt(Joint::kFootR, Joint::kFootL, {1, 1, 1, false}), 0);
  Parameters exact;
  exact.ik = Ik::kExact;
  EXPECT_EQ(Engine{exact}.goals()[Joint::kPelvR], 2057);
  EXPECT_EQ(Engine{exact}.goals()[Joint::kPelvL], 2039);
}

TEST(GaitEngine, StandsBeforeTheStart) {
  Engine engine{Parameters{}};
  EXPECT_EQ(engine.goals().tick, kStanding.tick);
  for (int call = 0; call < 200; ++call) ASSERT_EQ(engine.next({1, 1, 1, false}, kUnseen).tick, kStanding.tick);
  EXPECT_FALSE(engine.running());
}

/// Calls until it rests, from a stop before this call; at most 1000.
int callsToRest(const Wish& wish, int stop_before) {
  Engine engine{Parameters{}};
  engine.start();
  for (int call = 0; call < stop_before; ++call) engine.next(wish, kUnseen);
  engine.stop();
  int calls = 0;
  while (engine.running() && calls < 1000) {
    engine.next(wish, kUnseen);
    ++calls;
  }
  EXPECT_EQ(engine.next(wish, kUnseen).tick, kStanding.tick) << stop_before;
  EXPECT_FALSE(engine.running());
  return calls;
}

TEST(GaitEngine, StopsStandingFromEveryMomentOfAPeriod) {
  for (int call = 0; call < 3 * kCallsPerPeriod; ++call) {
    EXPECT_LE(callsToRest({}, call), kCallsPerPeriod / 2 + 1) << call;
    EXPECT_LE(callsToRest({-1, 0.5, 1, false}, call), 3 * kCallsPerPeriod / 2 + 1) << call;
  }
}

TEST(GaitEngine, HonoursAStopBeforeTheFirstCall) {
  EXPECT_EQ(callsToRest({1, 0, 0, false}, 0), 1);
}

TEST(GaitEngine, WalksAgainAfterAStop) {
  Engine engine{shipped()}, fresh{shipped()};
  engine.start();
  for (int call = 0; call < 10; ++call) engine.next({}, kUnseen);
  engine.stop();
  while (engine.running()) engine.next({}, kUnseen);
  engine.start();
  fresh.start();
  // It rests in the middle of the period: the right foot is the next, half a period away from the left one's.
  for (int call = 0; call < 37; ++call) fresh.next({}, kUnseen);
  for (int call = 0; call < 300; ++call) ASSERT_EQ(engine.next({}, kUnseen).tick, fresh.next({}, kUnseen).tick) << call;
}

TEST(GaitEngine, IgnoresATiltThatIsNotKnown) {
  Engine blind{Parameters{}}, half_blind{Parameters{}}, lost{Parameters{}};
  for (Engine* engine : {&blind, &half_blind, &lost}) engine->start();
  for (int call = 0; call < 200; ++call) {
    const auto expected = blind.next({1, 0, 0, false}, kUnseen).tick;
    ASSERT_EQ(half_blind.next({1, 0, 0, false}, {30, kNaN}).tick, expected);
    ASSERT_EQ(lost.next({1, 0, 0, false}, {HUGE_VAL, 0}).tick, expected);
  }
}

TEST(GaitEngine, LeansAgainstAFall) {
  Engine engine{Parameters{}};
  const Goals level = engine.next({}, {0, 0});
  EXPECT_EQ(level.tick, kStanding.tick);
  const Goals forwards = engine.next({}, {0, -10});
  EXPECT_EQ(forwards[Joint::kLegLowerR] - level[Joint::kLegLowerR], 12);  // knees bend
  EXPECT_EQ(forwards[Joint::kLegLowerL] - level[Joint::kLegLowerL], -12);
  EXPECT_EQ(forwards[Joint::kAnkleR] - level[Joint::kAnkleR], -36);  // toes press
  EXPECT_EQ(forwards[Joint::kAnkleL] - level[Joint::kAnkleL], 36);
  const Goals left = engine.next({}, {10, 0});
  EXPECT_EQ(left[Joint::kPelvR] - level[Joint::kPelvR], -20);
  EXPECT_EQ(left[Joint::kPelvL] - level[Joint::kPelvL], -20);
  EXPECT_EQ(left[Joint::kFootR] - level[Joint::kFootR], -40);
  EXPECT_EQ(left[Joint::kFootL] - level[Joint::kFootL], -40);
}

TEST(GaitEngine, KeepsItsGoalsWhereALegCannotReach) {
  Parameters torn;  // as no file can ask for it
  torn.z_offset = -100;
  Engine engine{torn};
  engine.start();
  for (int call = 0; call < 200; ++call) ASSERT_EQ(engine.next({1, 1, 1, false}, {50, 50}).tick, kStanding.tick);
}

TEST(GaitEngine, GivesTheArmsSoftServosAndTheLegsThoseOfTheFile) {
  Parameters p;
  p.p_gain = 40;
  EXPECT_EQ(pGain(Joint::kShoulderR, p), 8);
  EXPECT_EQ(pGain(Joint::kArmLowerL, p), 8);
  EXPECT_EQ(pGain(Joint::kPelvYR, p), 40);
  EXPECT_EQ(pGain(Joint::kFootL, p), 40);
}

}  // namespace
}  // namespace darwinop::gait
