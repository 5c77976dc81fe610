// Commands of a run, step by step, and the return to the start pose.
#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "experiments/format/texts.hpp"
#include "experiments/run/rig.hpp"

namespace darwinop::experiments {
namespace {

const JointCommand& neck(const VirtualRun::Row& row) {
  return row.asked.joint[index(Joint::kNeck)];
}
double neckAngle(const VirtualRun::Row& row) {
  return row.seen.joint[index(Joint::kNeck)].position.value;
}

TEST(Run, SendsTheCommandsOfThePhase) {
  VirtualRun run{phase(kStep + "p_gain = 2\ntorque_limit = 1 N m\n")};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  const auto rows = run.rowsOf("turn");
  ASSERT_NEAR(run.secondsOf(rows), 1, 0.02) << "1 s, in steps of 16 ms";
  for (const auto& row : rows) {
    EXPECT_NEAR(neck(row).goal.value, 0.5236, 1e-4);
    EXPECT_EQ(neck(row).speed_limit.value, 2);
    EXPECT_EQ(neck(row).p_gain, 2);
    EXPECT_EQ(neck(row).torque_limit.value, 1);
  }
}

TEST(Run, SettingsEndWithTheirPhase) {
  VirtualRun run{phase(kStep + "p_gain = 2\ntorque_limit = 1 N m\n")};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  const JointCommand& last = neck(run.rows.back());
  EXPECT_EQ(last.p_gain, 4);
  EXPECT_EQ(last.torque_limit.value, 2.5);
  EXPECT_NEAR(last.speed_limit.value, 12.21, 1e-9);
}

TEST(Run, ArrivalEndsAPhaseEarly) {
  VirtualRun run{phase(kStep + "until = arrival\nwithin = 0.05 rad\n")};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  const auto rows = run.rowsOf("turn");
  EXPECT_NEAR(neckAngle(rows.back()), 0.5236, 0.05 + 1e-3);
  // 0.52 rad at 2 rad/s take 0.26 s, plus acceleration and the last degrees of a P controller.
  EXPECT_NEAR(run.secondsOf(rows), 0.35, 0.1);
}

TEST(Run, TorqueLimitRisesOverThePhase) {
  VirtualRun run{phase(kStep + "torque_limit = 0 N m to 2 N m\n")};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  const auto rows = run.rowsOf("turn");
  EXPECT_NEAR(neck(rows[rows.size() / 2]).torque_limit.value, 1, 0.05) << "half way, within a step of 0.032 N m";
  EXPECT_NEAR(neck(rows.back()).torque_limit.value, 2, 0.05);
}

TEST(Run, TorqueOffReleasesTheJoint) {
  VirtualRun run{phase("torque = off\n")};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  for (const auto& row : run.rowsOf("turn")) EXPECT_FALSE(neck(row).torque_on);
  EXPECT_TRUE(neck(run.rows.back()).torque_on) << "enabled again afterwards";
}

TEST(Run, NegativeTorquePushesToHigherAnglesAsInWebots) {
  VirtualRun run{phase("torque = -0.5 N m\n")};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  const auto rows = run.rowsOf("turn");
  EXPECT_EQ(neck(rows.back()).torque_limit.value, 0.5);
  EXPECT_GT(neckAngle(rows.back()), neckAngle(rows.front()) + 0.3);
}

TEST(Run, JointMovedByATorqueReturnsSlowly) {
  VirtualRun run{phase("torque = -0.5 N m\n")};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  const auto back = run.rowsOf(kReturnPhase);
  double fastest = 0;
  const std::size_t stopped = 20;  // 0.3 s to stop
  for (std::size_t i = stopped; i < back.size(); ++i)
    fastest = std::max(fastest, std::abs(neckAngle(back[i]) - neckAngle(back[i - 1])) / 0.016);
  EXPECT_GT(back.size(), 100U);
  EXPECT_LT(fastest, kSlow + 2 * kRadPerTick / 0.016) << "two ticks of rounding per step";
}

TEST(Run, JointMovedSlightlyIsHeldInPlace) {
  const std::string pushed =
      with(with(kNod, kStep, "torque = -0.1 N m\n"), "duration = 1 s\n[record]", "duration = 0.3 s\n[record]") +
      "[phase then]\njoints = Neck\ngoal = hold\nduration = 1 s\n";
  VirtualRun run{parseExperiment(pushed, "my.ini")};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  const double there = neckAngle(run.rowsOf("turn").back());
  ASSERT_GT(there, 0.02) << "no motion";
  ASSERT_LT(there, 0.1) << "below the threshold for a restart";
  EXPECT_NEAR(neck(run.rowsOf("then").front()).goal.value, there, 1e-6);
}

TEST(Run, JointDoesNotJumpWhenItsTorqueLimitReturns) {
  // With a very low torque limit the head stays behind its goal.
  const std::string weak = with(kNod, kStep, kStep + "torque_limit = 0.01 N m\n") +
                           "[phase then]\njoints = Neck\ngoal = move\nto = 0 rad\nduration = 2 s\n";
  VirtualRun run{parseExperiment(weak, "my.ini")};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  const auto before = run.rowsOf("turn");
  ASSERT_LT(neckAngle(before.back()), 0.3) << "must not arrive";
  EXPECT_NEAR(neck(run.rowsOf("then").front()).goal.value, neckAngle(before.back()), 0.02);
}

TEST(Run, AccelerationIsLimitedForThePhaseOnly) {
  VirtualRun run{phase(kStep + "acceleration = 5 rad/s2\n")};
  double in_phase = 0;
  run.on_step = [&](const std::string& name, double) {
    if (name == "turn") in_phase = run.motor("Neck").getAcceleration();
  };
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  EXPECT_EQ(in_phase, 5);
  EXPECT_EQ(run.motor("Neck").getAcceleration(), -1) << "default: no limit";
}

TEST(Run, RobotSettlesBeforeTheFirstPhase) {
  const std::string settling =
      with(kNod, "pose = start\nduration = 1 s", "pose = start\nduration = 1 s\nsettle = 0.8 s");
  VirtualRun run{parseExperiment(settling, "my.ini")};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  EXPECT_NEAR(run.secondsOf(run.rowsOf(kSetupPhase)), 1.8, 0.033) << "resolution of 16 ms at both ends";
}

TEST(Run, UnexpectedFallEndsTheExperiment) {
  VirtualRun run{phase(kStep)};
  double fell_at = 0, last = 0;
  run.on_step = [&](const std::string& name, double seconds) {
    last = seconds;
    if (name != "turn") return;
    if (fell_at == 0) fell_at = seconds;
    run.bend = [](Sensors& seen) {
      seen.board.accelerometer = {MeterPerSec2{0}, MeterPerSec2{-9.81}, MeterPerSec2{0}};
    };
  };
  EXPECT_EQ(run.run(), RunOutcome::kFellIn);
  EXPECT_NEAR(run.secondsOf(run.rowsOf("turn")), 0.25, 0.05) << "not the whole second";
  EXPECT_GT(last, fell_at + 0.5) << "returns to the start pose";
}

TEST(Run, MirroredJointMovesInTheOppositeDirection) {
  VirtualRun run{parseExperiment(with(kNod, "joints = Neck\ngoal", "joints = ShoulderR, -ShoulderL\ngoal"), "my.ini")};
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  const Commands asked = run.rowsOf("turn").back().asked;
  EXPECT_NEAR(asked.joint[index(Joint::kShoulderR)].goal.value, 0.5236, 1e-4);
  EXPECT_NEAR(asked.joint[index(Joint::kShoulderL)].goal.value, -0.5236, 1e-4);
}

TEST(Run, JointBeyondItsLimitIsHeldAtTheLimit) {
  VirtualRun run{parseExperiment(
      with(kNod, kStep, "torque = off\n") + "[phase then]\njoints = Neck\ngoal = hold\nduration = 1 s\n", "my.ini")};
  run.on_step = [&](const std::string& name, double) {
    if (name == "turn") run.bend = [](Sensors& seen) { seen.joint[index(Joint::kNeck)].position = Rad{1.75}; };
  };
  EXPECT_EQ(run.run(), RunOutcome::kDone);
  EXPECT_NEAR(neck(run.rowsOf("then").front()).goal.value, run.motor("Neck").getMaxPosition(), 1e-9);
  EXPECT_LT(run.motor("Neck").getMaxPosition(), 1.7);
}

TEST(Run, IsBitwiseRepeatable) {
  const Experiment experiment = phase("goal = multisine\namplitude = 0.5 rad\nfrequency = 0.5 Hz, 2 Hz\n");
  const auto rows_of_a_run = [&] {  // one after the other: a process has one robot
    VirtualRun run{experiment};
    EXPECT_EQ(run.run(), RunOutcome::kDone);
    return run.rows;
  };
  const auto one = rows_of_a_run(), two = rows_of_a_run();
  ASSERT_EQ(one.size(), two.size());
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };  // NaN equals NaN
  for (std::size_t i = 0; i < one.size(); ++i) ASSERT_EQ(bits(neckAngle(one[i])), bits(neckAngle(two[i]))) << i;
}

}  // namespace
}  // namespace darwinop::experiments
