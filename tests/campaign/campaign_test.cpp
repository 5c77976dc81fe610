// Long runs under random faults: whatever happens on the line, to the robot and in the controller, the promises
// of the safety layer hold, nothing old passes for new, and all is well again soon after.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

#include "campaign/wild_controller.hpp"
#include "campaign/wire_judge.hpp"
#include "hal/cm730/bus.hpp"
#include "hil-mocks/fault.hpp"
#include "hil-mocks/memory_line.hpp"
#include "hil-mocks/virtual_robot.hpp"
#include "runtime/cycle.hpp"
#include "safety/guard.hpp"

namespace darwinop {
namespace {

using hil::FaultKind;
constexpr Nanos kPeriod{16'000'000};

double seconds(Nanos time) {
  return std::chrono::duration<double>(time).count();
}

std::uint64_t seedFromEnvironment() {
  if (const char* text = std::getenv("DARWINOP_SEED")) return std::strtoull(text, nullptr, 10);
  return std::random_device{}();
}

long cyclesFromEnvironment(long usual) {
  if (const char* text = std::getenv("DARWINOP_CAMPAIGN_CYCLES")) return std::strtol(text, nullptr, 10);
  return usual;
}

/// A servo that gets its supply back needs a while to start, like a real one.
hil::BoardOptions slowStarters() {
  hil::BoardOptions options;
  options.servo_boot = Nanos{200'000'000};
  return options;
}

struct Campaign {
  explicit Campaign(std::uint64_t seed) : robot{slowStarters(), seed}, controller{seed} { line.observe(&judge); }

  void cycle(const Commands& asked) {
    release += kPeriod;
    line.advanceTo(release);
    judge.beginCycle();
    const auto before = robot.body().state();
    loop.run(asked, {.release = release, .wake_latency = line.now() - release});
    judge.endCycle(loop.sensors());
    checkReadings(before, robot.body().state());
  }

  /// A value that says it is fresh must lie where the joint was during this very cycle.
  void checkReadings(const BodyState& before, const BodyState& after) {
    for (std::size_t i = 0; i < kJoints; ++i) {
      const JointSensors& joint = loop.sensors().joint[i];
      if (!joint.motion.fresh()) continue;
      ++readings;
      const JointMotion &then = before.joint[i], &now = after.joint[i];
      const auto [low, high] = std::minmax(then.position_rad, now.position_rad);
      // A joint that turned back within the cycle was further out in between than at both ends.
      const double speed = std::max(std::abs(then.velocity_rad_s), std::abs(now.velocity_rad_s));
      const double turn = then.velocity_rad_s * now.velocity_rad_s < 0 ? speed * seconds(kPeriod) / 2 : 0;
      const double slack = turn + 4 * kRadPerTick;  // and quantisation
      if (joint.position.value < low - slack || joint.position.value > high + slack) ++wrong;
    }
    for (const JointMotion& joint : after.joint) fastest = std::max(fastest, std::abs(joint.velocity_rad_s));
  }

  [[nodiscard]] bool well() const {
    const Sensors& s = loop.sensors();
    return s.safety.state == State::kDriven && s.board.motion.fresh() &&
           std::ranges::all_of(s.joint, [](const auto& j) { return j.motion.fresh() && j.driven; });
  }

  hil::VirtualRobot robot;
  hil::MemoryLine line{robot};
  cm730::Cm730Bus bus{line, cm730::BusConfig::forPeriod(kPeriod)};
  safety::Config config{};
  safety::Guard guard{config};
  runtime::Cycle loop{bus, guard, kPeriod};
  WireJudge judge{robot, kPeriod, config.max_joint_speed};
  WildController controller;
  Nanos release{0};
  long readings = 0, wrong = 0;
  double fastest = 0;
};

hil::Fault randomFaults(double per_second, hil::FaultKinds kinds) {
  hil::Fault fault;
  fault.kind = FaultKind::kRandom;
  fault.amount = per_second;
  fault.kinds = kinds;
  return fault;
}

hil::FaultKinds kindsThatKeepBytesWhole() {
  hil::FaultKinds kinds;
  for (const FaultKind kind : {FaultKind::kDead, FaultKind::kErrors, FaultKind::kHeat, FaultKind::kVoltage,
                               FaultKind::kReset, FaultKind::kButton, FaultKind::kFallen, FaultKind::kStall,
                               FaultKind::kUnplug, FaultKind::kRepeatFrame, FaultKind::kDelay})
    kinds.set(static_cast<std::size_t>(kind));
  return kinds;
}

constexpr int kRecoveryCycles = 500;  // 8 s: servo boot 0.3 s, and the gentle way to the start pose and back

void fightThenRecover(Campaign& campaign, long cycles, hil::FaultKinds kinds) {
  campaign.robot.faults().add(randomFaults(2.0, kinds));
  for (long i = 0; i < cycles && campaign.judge.complaint().empty(); ++i) {
    campaign.cycle(campaign.controller.next());
    // Now and then peace, and the robot must come back to full order.
    if (i % 5000 != 4999) continue;
    campaign.robot.faults().clear();
    int recovery = 0;
    while (!campaign.well() && recovery < 10 * kRecoveryCycles) campaign.cycle(campaign.controller.calm()), ++recovery;
    ASSERT_LE(recovery, kRecoveryCycles) << "at cycle " << i << ", state "
                                         << kStateNames[static_cast<std::size_t>(campaign.loop.sensors().safety.state)]
                                         << ", worst fault " << row(campaign.loop.sensors().safety.worst).name;
    campaign.robot.faults().add(randomFaults(2.0, kinds));
  }
  EXPECT_EQ(campaign.judge.complaint(), "");
  EXPECT_GT(campaign.judge.goalsSeen(), cycles);  // it did drive
  EXPECT_LE(campaign.fastest, campaign.config.max_joint_speed);
}

TEST(Campaign, NothingStalePassesForFreshAndNoGoalBreaksALimit) {
  const std::uint64_t seed = seedFromEnvironment();
  SCOPED_TRACE("DARWINOP_SEED=" + std::to_string(seed));
  Campaign campaign{seed};
  fightThenRecover(campaign, cyclesFromEnvironment(10'000), kindsThatKeepBytesWhole());
  EXPECT_EQ(campaign.wrong, 0);
  std::cout << "seed " << seed << ": " << campaign.readings << " fresh readings, " << campaign.judge.goalsSeen()
            << " goals, " << campaign.robot.faults().begun() << " faults\n";
}

TEST(Campaign, LimitsHoldWhenBytesAreLostAndDamagedToo) {
  const std::uint64_t seed = seedFromEnvironment();
  SCOPED_TRACE("DARWINOP_SEED=" + std::to_string(seed));
  Campaign campaign{seed};
  fightThenRecover(campaign, cyclesFromEnvironment(10'000), ~hil::FaultKinds{});
  // An 8-bit sum lets one damaged frame in 256 pass; that is the protocol's limit, not ours.
  EXPECT_LE(static_cast<double>(campaign.wrong), 1 + 1e-4 * static_cast<double>(campaign.readings));
}

}  // namespace
}  // namespace darwinop
