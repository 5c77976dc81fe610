// A guard, a fake robot and a controller that steps, with what must always hold checked in every cycle.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "safety/fake_robot.hpp"
#include "safety/guard.hpp"

namespace darwinop::safety {

using Write = SafeCommands::Write;

/// What must hold for every cycle, whatever is asked and seen. Returns what is wrong, or nothing.
class Invariants {
 public:
  explicit Invariants(const Config& config) : config_{config} {}

  std::string check(const SafeCommands& safe, const Sensors& seen) {
    std::string wrong;
    const double dt = static_cast<double>(seen.period_ns > 0 ? seen.period_ns : config_.period.count()) * 1e-9;
    const auto reject = [&](std::size_t i, const char* what) {
      wrong += std::string{kJointTable[i].name} + ": " + what + "; ";
    };
    const bool nothing = safe.write() == Write::kNothing;
    if (nothing && (safe.driven().any() || safe.torqueOn().any() || safe.torqueOff().any()))
      wrong += "joints without a write; ";
    const Freshness& link = seen.board.absent ? seen.bus : seen.board.motion;
    const bool offline = !link.ever() || link.age > kAnswerPatience;
    if (offline && (!nothing || safe.powerOn())) wrong += "sent while offline; ";
    if ((safe.torqueOn() & safe.torqueOff()).any()) wrong += "torque on and off at once; ";
    if ((safe.skipped() & safe.torqueOn()).any()) wrong += "torque on although it is uncertain where the goal is; ";
    if ((safe.driven() & safe.torqueOff()).any()) wrong += "driven although torque goes off; ";
    for (std::size_t i = 0; i < kJoints; ++i) {
      const auto& goal = safe.goal(static_cast<Joint>(i));
      if (safe.driven()[i]) {
        const JointRange& range = config_.range[i];
        if (!(goal.goal.value >= range.low.value && goal.goal.value <= range.high.value)) reject(i, "goal");
        if (!(goal.speed_limit.value >= 0.0119 && goal.speed_limit.value <= 12.22)) reject(i, "speed");
        if (!(goal.torque_limit.value > 0 && goal.torque_limit.value <= 2.5)) reject(i, "torque");
        if (!(goal.p_gain >= 0 && goal.p_gain <= 31.75)) reject(i, "gain");
        const bool small_step =
            last_goal_[i] && std::abs(goal.goal.value - *last_goal_[i]) <= config_.max_joint_speed * dt + 1e-9;
        if (was_driven_[i] && !small_step) reject(i, "step");
        // A joint that comes back goes on where it stood, or gently from where it is.
        if (!was_driven_[i] && !small_step && goal.speed_limit.value > config_.gentle_speed + 1e-9)
          reject(i, "first goal not gentle");
        last_goal_[i] = goal.goal.value;
      }
      was_driven_[i] = safe.driven()[i];
    }
    return wrong;
  }

 private:
  Config config_;
  std::array<std::optional<double>, kJoints> last_goal_{};
  std::array<bool, kJoints> was_driven_{};
};

struct Rig {
  explicit Rig(const Config& c = {}) : config{c}, guard{c}, invariants{c} { robot.period_ns = c.period.count(); }

  Config config;
  Guard guard;
  FakeRobot robot;
  Invariants invariants;
  Commands commands{};
  bool steps = true;                     // the controller is alive
  std::function<void(Rig&)> controller;  // what it does in each step
  std::optional<SafeCommands> safe;

  JointCommand& joint(Joint j) { return commands.joint[index(j)]; }
  double goal(Joint j) const { return safe->goal(j).goal.value; }
  bool driven(Joint j) const { return safe->driven()[index(j)]; }
  bool skipped(Joint j) const { return safe->skipped()[index(j)]; }
  const SafetyReport& report() const { return guard.report(); }
  State state() const { return report().state; }
  bool active(Fault fault) const { return report().active[rowIndex(fault)]; }

  void cycle() {
    if (steps && controller) controller(*this);
    if (steps && commands.session != 0) ++commands.sequence;
    const Sensors before = robot.seen;
    safe = guard.vet(commands, before);
    EXPECT_EQ(invariants.check(*safe, before), "") << "cycle " << before.cycle;
    robot.cycle(*safe);
  }
  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) cycle();
  }
  void runFor(double seconds) { run(static_cast<int>(seconds * 1e9 / static_cast<double>(robot.period_ns))); }
  /// Runs until `done`, for 30 s at most; the number of cycles it took, or -1.
  int runUntil(const std::function<bool()>& done) {
    for (int i = 0; i < 2000; ++i) {
      if (done()) return i;
      cycle();
    }
    return -1;
  }
  bool reach(State wanted) {
    return runUntil([&] { return state() == wanted; }) >= 0;
  }
  void newSession() { ++commands.session; }
  /// A controller starts, and the start pose is reached.
  void start() {
    newSession();
    ASSERT_TRUE(reach(State::kDriven)) << kStateNames[static_cast<std::size_t>(state())];
  }
};

}  // namespace darwinop::safety
