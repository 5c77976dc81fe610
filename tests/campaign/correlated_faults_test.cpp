// Faults that hit many servos at once, at every moment of a cycle and of a start: one row each of what has gone wrong
// on robots. Judged at the servos.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "campaign/campaign.hpp"
#include "support/every_case.hpp"

namespace darwinop {
namespace {

using hil::FaultKind;
using std::chrono::milliseconds;

/// A controller as it should be: smooth goals, no resets.
class SteadyController {
 public:
  enum class Streams : std::uint8_t { kGoals, kSpeedLimits, kTorqueLimits };

  explicit SteadyController(Streams streams = Streams::kGoals) : streams_{streams} { image_.session = 1; }

  const Commands& next() {
    ++image_.sequence;
    const auto t = static_cast<double>(image_.sequence);
    for (std::size_t i = 0; i < kJoints; ++i) {
      JointCommand& joint = image_.joint[i];
      const JointRow& r = kJointTable[i];
      const double reach = 0.25 * (r.high - r.low) * kRadPerTick;
      joint.setGoal(Rad{radFromTicks(r.start).value + reach * std::sin(0.03 * t)});
      if (streams_ == Streams::kSpeedLimits) joint.setSpeedLimit(RadPerSec{4 + std::sin(0.3 * t)});
      if (streams_ == Streams::kTorqueLimits) joint.setTorqueLimit(NewtonMeter{2 + 0.4 * std::sin(0.3 * t)});
    }
    return image_;
  }

 private:
  Streams streams_;
  Commands image_;
};

struct Scene : Campaign {
  explicit Scene(SteadyController::Streams streams = SteadyController::Streams::kGoals)
      : Campaign{1}, steady{streams} {}

  void run(int count) {
    for (int i = 0; i < count && failure().empty(); ++i) cycle(steady.next());
  }
  /// Driven, and in the middle of a motion.
  void runUntilDriven() {
    for (int i = 0; i < 500 && !well(); ++i) run(1);
    run(50);
    ASSERT_TRUE(well());
  }
  void add(FaultKind kind, Nanos in, Nanos lasts, std::bitset<kJoints> joints = {}) {
    hil::InjectedFault fault;
    fault.kind = kind;
    fault.at = line.now() + in;
    fault.lasts = lasts;
    fault.joints = joints;
    add(fault);
  }
  void add(const hil::InjectedFault& fault) { robot.faults().add(fault); }
  [[nodiscard]] State state() const { return loop.sensors().safety.state; }
  [[nodiscard]] int pulling() const {
    int count = 0;
    for (std::size_t i = 0; i < kJoints; ++i)
      count += robot.board().servo(static_cast<Joint>(i)).state().pulls() ? 1 : 0;
    return count;
  }

  SteadyController steady;
};

template <class Is>
std::bitset<kJoints> joints(Is is) {
  std::bitset<kJoints> all;
  for (std::size_t i = 0; i < kJoints; ++i) all[i] = is(kJointTable[i]);
  return all;
}

struct Group {
  const char* name;
  std::bitset<kJoints> joints;
};
const std::array kGroups{
    Group{"a knee", joints([](const JointRow& r) { return r.id == 14; })},
    Group{"an ankle and what hangs behind it",
          joints([](const JointRow& r) { return r.chain == Chain::kLeftLeg && r.id >= 16; })},
    Group{"a leg", joints([](const JointRow& r) { return r.chain == Chain::kLeftLeg; })},
    Group{"both legs",  // no message
          joints([](const JointRow& r) { return r.chain == Chain::kLeftLeg || r.chain == Chain::kRightLeg; })},
    Group{"the right side", joints([](const JointRow& r) { return r.id % 2 == 1; })},
    Group{"all servos", std::bitset<kJoints>{}.set()},  // no message
};

TEST(CorrelatedFaults, ServosThatLoseTheirSupplyTogetherComeBackWithoutAJump) {
  for (const Group& group : kGroups)
    for (const int dropout_ms : {1, 30, 300})
      for (const int boot_ms : {5, 60, 200, 500}) {
        SCOPED_TRACE(std::string{group.name} + " for " + std::to_string(dropout_ms) + " ms, boot " +
                     std::to_string(boot_ms) + " ms");
        Scene scene;
        scene.runUntilDriven();
        hil::InjectedFault dead;
        dead.kind = FaultKind::kDead;
        dead.at = scene.line.now() + milliseconds{3};
        dead.lasts = milliseconds{dropout_ms};
        dead.joints = group.joints;
        dead.boot = milliseconds{boot_ms};
        scene.add(dead);
        scene.run(200);
        EXPECT_EQ(scene.failure(), "");
        EXPECT_TRUE(scene.well());
      }
}

TEST(CorrelatedFaults, FiveLostAnswersInARowNeverInterruptDriving) {
  for (const int count : {1, 2, 3, 4, 5})
    for (int phase_ms = 0; phase_ms < 16; phase_ms += 5) {
      SCOPED_TRACE(std::to_string(count) + " lost answers, phase " + std::to_string(phase_ms) + " ms");
      Scene scene;
      scene.runUntilDriven();
      hil::InjectedFault miss;
      miss.kind = FaultKind::kMiss;
      miss.at = scene.line.now() + milliseconds{phase_ms};
      miss.amount = count;
      scene.add(miss);
      for (int i = 0; i < 40; ++i) {
        scene.run(1);
        EXPECT_EQ(scene.state(), State::kDriven);
        EXPECT_EQ(scene.pulling(), 20);
      }
      EXPECT_EQ(scene.servo_judge.tally().outages, 0);
      EXPECT_EQ(scene.failure(), "");
      EXPECT_TRUE(scene.well());
    }
}

TEST(CorrelatedFaults, SixToEightLostAnswersCostNoMoreThanAGentleTakeover) {
  for (const int count : {6, 7, 8}) {
    Scene scene;
    scene.runUntilDriven();
    hil::InjectedFault miss;
    miss.kind = FaultKind::kMiss;
    miss.at = scene.line.now();
    miss.amount = count;
    scene.add(miss);
    scene.run(200);
    EXPECT_EQ(scene.failure(), "");
    EXPECT_TRUE(scene.well());
  }
}

/// Shutdowns of a stuck knee until one was believed,.
long shutdownsOfAStuckKnee(SteadyController::Streams streams, int phase_ms) {
  Scene scene{streams};
  scene.runUntilDriven();
  hil::InjectedFault jam;
  jam.kind = FaultKind::kJam;
  jam.at = scene.line.now() + milliseconds{phase_ms};
  jam.amount = 1;  // s
  jam.joints = joints([](const JointRow& r) { return r.id == 13; });
  scene.add(jam);
  for (int i = 0; i < 1000 && !scene.loop.sensors().safety.tripped[12]; ++i) scene.run(1);
  EXPECT_TRUE(scene.loop.sensors().safety.tripped[12]);
  EXPECT_EQ(scene.failure(), "");
  return scene.servo_judge.tally().trips;
}

TEST(CorrelatedFaults, AShutdownAtAnyMomentOfTheCycleIsBelievedAtOnceWhateverIsStreamed) {
  using enum SteadyController::Streams;
  for (const auto streams : {kGoals, kSpeedLimits})
    for (int phase_ms = 0; phase_ms < 16; ++phase_ms) {
      SCOPED_TRACE("phase " + std::to_string(phase_ms) + " ms");
      EXPECT_EQ(shutdownsOfAStuckKnee(streams, phase_ms), 1);
    }
}

// 256 ms: new limits are sent in every 8th to 15th cycle.
TEST(CorrelatedFaults, AStreamOfTorqueLimitsHidesNoShutdown) {
  for (int phase_ms = 0; phase_ms < 256; phase_ms += kNextCase)
    EXPECT_EQ(shutdownsOfAStuckKnee(SteadyController::Streams::kTorqueLimits, phase_ms), 1) << phase_ms << " ms";
}

TEST(CorrelatedFaults, ModeAndResetEndTorqueAtAnyMomentAndOnlyAPersonBringsItBack) {
  for (const bool reset : {false, true})
    for (int after = 10; after < 400; after += 30) {
      SCOPED_TRACE(std::string{reset ? "RESET" : "MODE"} + " after " + std::to_string(after) + " cycles");
      Scene scene;
      scene.run(after);
      const bool was_up = scene.pulling() > 0;
      hil::InjectedFault press;
      press.kind = reset ? FaultKind::kReset : FaultKind::kButton;
      press.bits = 1;
      press.at = scene.line.now() + milliseconds{after % 16};
      press.lasts = milliseconds{400};
      scene.add(press);
      scene.run(200);
      EXPECT_EQ(scene.failure(), "");
      if (reset && !was_up) continue;  // nothing was held: RESET released nothing
      EXPECT_EQ(scene.pulling(), 0);
      EXPECT_EQ(scene.state(), State::kLimp);
      press.kind = FaultKind::kButton;
      press.bits = 2;  // START
      press.at = scene.line.now();
      scene.add(press);
      scene.run(500);
      EXPECT_EQ(scene.failure(), "");
      EXPECT_EQ(scene.state(), State::kDriven);
    }
}

TEST(CorrelatedFaults, ResetInTheMiddleOfAKneelLeavesTheRobotLimp) {
  for (int after = 5; after < 65; after += 15) {
    Scene scene;
    scene.runUntilDriven();
    hil::InjectedFault flat;  // kneels
    flat.kind = FaultKind::kVoltage;
    flat.amount = 9.5;
    flat.at = scene.line.now();
    flat.lasts = milliseconds{4000};
    scene.add(flat);
    for (int i = 0; i < 300 && scene.state() != State::kKneeling; ++i) scene.run(1);
    ASSERT_EQ(scene.state(), State::kKneeling);
    scene.run(after);
    const bool was_up = scene.pulling() > 0;
    hil::InjectedFault reset;
    reset.at = scene.line.now();
    scene.add(reset);
    scene.run(400);
    EXPECT_EQ(scene.failure(), "");
    EXPECT_TRUE(was_up);
    EXPECT_EQ(scene.pulling(), 0);
    EXPECT_EQ(scene.state(), State::kLimp);
  }
}

// The supply falls with what the servos draw: torque, brown-out, torque again must not go on for ever, nor jump.
TEST(CorrelatedFaults, ASupplyThatGivesWayUnderTorqueNeverMakesAJointJump) {
  for (const double sag_v : {10.0, 30.0, 60.0, 100.0}) {
    Scene scene;
    scene.runUntilDriven();
    hil::InjectedFault sag;
    sag.kind = FaultKind::kSag;
    sag.amount = sag_v;
    sag.at = scene.line.now();
    sag.lasts = milliseconds{5000};
    scene.add(sag);
    scene.run(400);
    EXPECT_EQ(scene.failure(), "") << sag_v;
    scene.run(500);
    EXPECT_TRUE(scene.well()) << sag_v;
  }
}

}  // namespace
}  // namespace darwinop
