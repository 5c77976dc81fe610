// What holds for any commands and any robot: random controllers, random faults, corrupted readings.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <random>

#include "safety/fake_robot.hpp"
#include "safety/guard.hpp"
#include "safety/rig.hpp"

namespace darwinop::safety {
namespace {

/// Random numbers from one seed, so that a failure is repeated by its seed (printed by RapidCheck).
class Rng {
 public:
  explicit Rng(std::uint32_t seed) : engine_{seed} {}
  bool one(int in) { return std::uniform_int_distribution{1, in}(engine_) == 1; }
  int upTo(int most) { return std::uniform_int_distribution{0, most}(engine_); }
  double number(double low, double high) { return std::uniform_real_distribution{low, high}(engine_); }
  /// Anything a double can be.
  double wild() {
    using Limits = std::numeric_limits<double>;
    constexpr std::array kWild{Limits::quiet_NaN(),
                               Limits::infinity(),
                               -Limits::infinity(),
                               Limits::max(),
                               Limits::lowest(),
                               Limits::denorm_min(),
                               0.0,
                               -0.0};
    return one(4) ? kWild[static_cast<std::size_t>(upTo(kWild.size() - 1))] : number(-5, 5);
  }

 private:
  std::mt19937 engine_;
};

void command(Commands& c, Rng& rng) {
  if (!rng.one(40)) ++c.sequence;
  if (rng.one(400)) ++c.session;
  if (rng.one(300)) ++c.fault_resets;
  if (rng.one(500)) c.start_where_it_is = !c.start_where_it_is;
  if (rng.one(2000)) c.end_of_session = !c.end_of_session;
  if (rng.one(3)) return;
  JointCommand& joint = c.joint[static_cast<std::size_t>(rng.upTo(kJoints - 1))];
  if (rng.one(2)) joint.setGoal(Rad{rng.wild()});
  if (rng.one(5)) joint.setSpeedLimit(RadPerSec{rng.wild()});
  if (rng.one(5)) joint.setTorqueLimit(NewtonMeter{rng.wild()});
  if (rng.one(5)) joint.setPGain(rng.wild());
  if (rng.one(40)) joint.setTorque(rng.one(2));
  if (rng.one(20)) joint.set = static_cast<std::uint8_t>(rng.upTo(31));
}

void disturb(FakeRobot& robot, Rng& rng) {
  robot.board_answers = robot.board_answers ? !rng.one(150) : rng.one(8);
  if (rng.one(1500)) robot.servo_power = false;
  robot.power_obeys = !rng.one(2);
  if (rng.one(700)) robot.volt = rng.number(8, 13);
  if (rng.one(900)) robot.buttons = static_cast<std::uint8_t>(rng.upTo(3));
  if (rng.one(300)) robot.acceleration = {rng.number(-10, 10), rng.number(-10, 10), rng.number(-10, 10)};
  for (FakeServo& s : robot.servo) {
    s.answers = s.answers ? !rng.one(100) : rng.one(12);
    s.receives = !rng.one(50);
    if (rng.one(60)) s.corruption = rng.number(-4, 4);
    if (rng.one(2000)) s.celsius = rng.number(20, 90);
    if (rng.one(400)) s.error_bits = rng.one(3) ? static_cast<std::uint8_t>(rng.upTo(127)) : std::uint8_t{0};
    if (rng.one(800)) s.torque = false;
    if (rng.one(1500)) s.torque_limit = 0;
    if (!s.torque && rng.one(200)) s.position += rng.number(-0.5, 0.5);  // moved by hand
  }
  for (std::size_t i = 0; i < kJoints; ++i) robot.given_up[i] = !robot.servo[i].answers && rng.one(2);
}

/// Joints whose torque the controller has switched off until it ended its session, as a reader of the images would keep
/// it.
class TorqueRequests {
 public:
  void take(const Commands& c) {
    if (c.session == 0) return;
    if (c.session != session_) *this = {};
    session_ = c.session;
    if (ended_) return;
    ended_ = c.end_of_session;
    for (std::size_t i = 0; i < kJoints; ++i)
      if (c.joint[i].has(JointCommand::kTorque)) off_[i] = !c.joint[i].torque_on;
  }
  [[nodiscard]] const std::bitset<kJoints>& off() const { return off_; }

 private:
  std::uint32_t session_ = 0;
  bool ended_ = false;
  std::bitset<kJoints> off_;
};

/// A joint that enters must be where its goal is: checked against the truth, not against the reading.
void checkFirstGoals(const SafeCommands& safe, const std::bitset<kJoints>& driven_before, const FakeRobot& robot,
                     const std::array<double, kJoints>& last_goal) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (!safe.driven()[i] || driven_before[i]) continue;
    const double goal = safe.goal(static_cast<Joint>(i)).goal.value;
    const JointRange range = hardRange(static_cast<Joint>(i));
    const double present = std::clamp(robot.servo[i].position, range.low.value, range.high.value);
    const bool resumed = std::abs(goal - last_goal[i]) <= 12.26 * 0.016 + 1e-9;
    RC_ASSERT(resumed || std::abs(goal - present) <= 9 * kRadPerTick);
  }
}

RC_GTEST_PROP(GuardProperty, WhateverHappensTheLimitsHold, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  Rng rng{seed};
  Config config;
  config.on_exit = static_cast<OnExit>(rng.upTo(2));
  config.on_fall = static_cast<OnFall>(rng.upTo(1));
  config.start = static_cast<StartMove>(rng.upTo(1));
  config.set("Limits", "Neck", "-0.5, 0.7");
  Guard guard{config};
  Invariants invariants{config};
  FakeRobot robot;
  robot.goal_write_switches_on = rng.one(2);
  Commands commands;
  commands.session = 1;
  TorqueRequests requests;
  for (int cycle = 0; cycle < 1500; ++cycle) {
    command(commands, rng);
    disturb(robot, rng);
    requests.take(commands);
    const SafeCommands safe = guard.vet(commands, robot.seen);
    const std::string wrong = invariants.check(safe, robot.seen);
    if (!wrong.empty()) RC_FAIL("cycle " + std::to_string(cycle) + ": " + wrong);
    RC_ASSERT((safe.driven() & requests.off()).none());
    RC_ASSERT((safe.torqueOn() & requests.off()).none());
    RC_ASSERT((safe.driven() & guard.report().tripped).none());
    RC_ASSERT((safe.torqueOn() & guard.report().tripped).none());
    robot.cycle(safe);
  }
}

RC_GTEST_PROP(GuardProperty, AJointEntersWhereItIsAlthoughReadingsAreCorrupted, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  Rng rng{seed};
  Guard guard{Config{}};
  FakeRobot robot;
  Commands commands;
  commands.session = 1;
  std::bitset<kJoints> driven_before;
  std::bitset<kJoints> was_wrong;
  std::array<double, kJoints> last_goal{};
  last_goal.fill(1e9);
  for (int cycle = 0; cycle < 1000; ++cycle) {
    ++commands.sequence;
    if (rng.one(200)) ++commands.session;
    const SafeCommands safe = guard.vet(commands, robot.seen);
    if (safe.write() == Write::kGoals) checkFirstGoals(safe, driven_before, robot, last_goal);
    for (std::size_t i = 0; i < kJoints; ++i)
      if (safe.driven()[i]) last_goal[i] = safe.goal(static_cast<Joint>(i)).goal.value;
    driven_before = safe.driven();
    for (std::size_t i = 0; i < kJoints; ++i) {
      FakeServo& s = robot.servo[i];
      s.answers = s.answers ? !rng.one(200) : rng.one(40);
      // Never two readings in a row, also with silence between them, and by more than a joint moves in a cycle: a
      // smaller one is indistinguishable from a motion.
      const bool is_wrong = s.answers && !was_wrong[i] && rng.one(9);
      if (s.answers) was_wrong[i] = is_wrong;
      s.corruption = is_wrong ? rng.number(0.25, 1) : 0;
      if (rng.one(100)) commands.joint[i].setTorque(!rng.one(3));
      if (rng.one(100)) commands.joint[i].setGoal(Rad{rng.number(-1, 1)});
      // By hand: together with a corrupted reading still more than a joint moves in a cycle, 0.196 rad.
      if (!s.torque && rng.one(50)) s.position += rng.number(-0.05, 0.05);
    }
    robot.cycle(safe);
  }
}

RC_GTEST_PROP(GuardProperty, ATrippedServoIsNotDrivenUntilSomebodyAsks, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  Rng rng{seed};
  Rig rig;
  rig.start();
  rig.runFor(1);
  const auto i = static_cast<std::size_t>(rng.upTo(kJoints - 1));
  rig.robot.servo[i].error_bits = rng.one(2) ? error_bit::kOverload : error_bit::kOverheat;
  rig.robot.servo[i].torque = false;
  rig.robot.servo[i].torque_limit = 0;
  rig.run(3);
  RC_ASSERT(rig.report().tripped[i]);
  rig.robot.servo[i].error_bits = 0;
  for (int cycle = 0; cycle < 800; ++cycle) {
    const auto other = static_cast<std::size_t>(rng.upTo(kJoints - 1));
    if (other != i) rig.commands.joint[other].setTorque(rng.one(2));
    rig.commands.joint[i].setGoal(Rad{rng.wild()});
    if (rng.one(100)) rig.robot.board_answers = !rig.robot.board_answers;
    rig.robot.servo[i].answers = !rng.one(20);
    rig.cycle();
    RC_ASSERT(!rig.safe->driven()[i]);
    RC_ASSERT(!rig.safe->torqueOn()[i]);
  }
  rig.robot.board_answers = rig.robot.servo[i].answers = true;
  ++rig.commands.fault_resets;
  RC_ASSERT(rig.runUntil([&] { return rig.safe->driven()[i]; }) >= 0);
}

}  // namespace
}  // namespace darwinop::safety
