// The twin beside a robot: what is not compared, and when the twin is put into the measured pose again.
#include <gmock/gmock.h>

#include "gap/live/live_robot.hpp"
#include "gap/live/thresholds.hpp"

namespace darwinop::gap::live::test {
namespace {

const std::array<MeterPerSec2, 3> kOnItsSide{MeterPerSec2{kGravity}, MeterPerSec2{0}, MeterPerSec2{0}};

class LiveGaps : public ::testing::Test {
 protected:
  /// Changes each cycle before it is compared.
  template <class Change>
  void run(double seconds, Change change) {
    for (double t = 0; t < seconds; t += kPeriod) {
      LiveCycle cycle = robot_.next();
      change(cycle);
      comparison_.take(cycle);
    }
  }
  void run(double seconds) {
    run(seconds, [](LiveCycle&) {});
  }
  void lose(int cycles) {
    for (int i = 0; i < cycles; ++i) robot_.next();
  }
  [[nodiscard]] LiveReport report() const { return comparison_.report(); }
  [[nodiscard]] std::uint64_t resyncs(Resync reason) const {
    return report().resyncs[static_cast<std::size_t>(reason)];
  }

  LiveRobot robot_;
  LiveComparison comparison_{modelWith(""), Support::kClamped, kPeriod};
};

TEST_F(LiveGaps, NothingIsComparedBeforeTheFirstCycle) {
  EXPECT_EQ(report().state, LiveState::kNoData);
  EXPECT_TRUE(std::isnan(report().position_rad[kNeck].rms));
  EXPECT_TRUE(std::isnan(report().accel_m_s2[0].worst));
}

TEST_F(LiveGaps, AFewMissingCyclesAreCountedAndTheTwinGoesOn) {
  run(3);
  lose(kMostMissing);
  run(0.5);
  EXPECT_EQ(report().missing, kMostMissing);
  EXPECT_EQ(resyncs(Resync::kGap), 0);
  EXPECT_EQ(report().state, LiveState::kComparing);
}

TEST_F(LiveGaps, ALongGapPutsTheTwinIntoTheMeasuredPose) {
  run(3);
  lose(40);
  run(0.1);
  EXPECT_EQ(report().missing, 40);
  EXPECT_EQ(resyncs(Resync::kGap), 1);
  EXPECT_EQ(report().state, LiveState::kSettling);
  run(2);
  EXPECT_EQ(report().state, LiveState::kComparing);
  EXPECT_LT(report().position_rad[kElbow].worst, 3 * kRadPerTick);
}

TEST_F(LiveGaps, AServoThatDoesNotReplyIsNotCompared) {
  run(3, [](LiveCycle& cycle) {
    JointSensors& neck = cycle.sensors.joint[kNeck];
    neck.motion.age = Freshness::kNever;
    neck.position = Rad{}, neck.load = kUnknown;
  });
  EXPECT_TRUE(std::isnan(report().position_rad[kNeck].rms));
  EXPECT_TRUE(std::isnan(report().load[kNeck].newest));
  EXPECT_EQ(report().position_rad[kNeck].count, 0);
  EXPECT_TRUE(report().silent[kNeck]);
  EXPECT_LT(report().position_rad[kElbow].rms, kRadPerTick) << "the others are";
}

TEST_F(LiveGaps, AnOldReadingIsNotComparedAgain) {
  run(3, [](LiveCycle& cycle) {
    if (cycle.sensors.cycle % 4 != 0) cycle.sensors.joint[kNeck].motion.age = 1;
  });
  EXPECT_NEAR(static_cast<double>(report().position_rad[kNeck].count),
              static_cast<double>(report().position_rad[kElbow].count) / 4, 2);
}

TEST_F(LiveGaps, AJointWithoutTorqueIsNotComparedAndFollowsTheRobot) {
  run(3);
  const std::uint64_t at_start = resyncs(Resync::kTorque);
  for (int i = 0; i < 100; ++i) comparison_.take(robot_.next({kNeck}));
  EXPECT_FALSE(report().driven[kNeck]);
  EXPECT_TRUE(std::isnan(report().position_rad[kNeck].newest));
  EXPECT_LT(report().position_rad[kElbow].rms, kRadPerTick);
  EXPECT_EQ(resyncs(Resync::kTorque), at_start);
  run(2);
  EXPECT_EQ(resyncs(Resync::kTorque), at_start + 1);
  EXPECT_LT(report().position_rad[kNeck].worst, 3 * kRadPerTick);
}

TEST_F(LiveGaps, WithoutRepliesOfTheBoardNothingIsCompared) {
  run(2);
  run(1, [](LiveCycle& cycle) { cycle.sensors.board.motion.age = 100; });
  EXPECT_EQ(report().state, LiveState::kNoData);
  run(2);
  EXPECT_EQ(resyncs(Resync::kSilence), 1);
  EXPECT_EQ(report().state, LiveState::kComparing);
}

TEST_F(LiveGaps, NothingIsComparedWhileSafetyMovesTheRobot) {
  run(3);
  const std::uint64_t before = report().compared;
  run(1, [](LiveCycle& cycle) { cycle.sensors.safety.state = State::kStarting; });
  run(kSettle / 2);
  EXPECT_EQ(report().state, LiveState::kSettling);
  EXPECT_EQ(report().compared, before);
  run(kSettle);
  EXPECT_EQ(report().state, LiveState::kComparing);
}

TEST_F(LiveGaps, ATurnedTrunkTurnsTheStandOfTheTwin) {
  run(2);
  run(8, [](LiveCycle& cycle) { cycle.sensors.board.accelerometer = kOnItsSide; });
  EXPECT_EQ(resyncs(Resync::kTurned), 1);
  EXPECT_EQ(report().up, (Axes{-1, 0, 0}));
  EXPECT_EQ(report().state, LiveState::kComparing);
}

TEST_F(LiveGaps, ATrunkThatIsTurnedForLongIsNotComparedMeanwhileAndLeavesNoTrace) {
  run(4);
  const LiveReport before = report();
  run(0.5, [](LiveCycle& cycle) { cycle.sensors.board.accelerometer = kOnItsSide; });
  double angle = 0;
  const auto turn = [&](LiveCycle& cycle) {
    angle += 3 * kPeriod;
    cycle.sensors.board.accelerometer = {MeterPerSec2{kGravity * std::cos(angle)}, MeterPerSec2{0},
                                         MeterPerSec2{kGravity * std::sin(angle)}};
    cycle.sensors.board.gyro[1] = RadPerSec{3};
  };
  run(1, turn);
  EXPECT_EQ(report().state, LiveState::kSettling);
  const std::uint64_t compared = report().compared;
  run(2, turn);
  EXPECT_EQ(report().state, LiveState::kSettling);
  EXPECT_EQ(report().compared, compared);
  EXPECT_EQ(report().accel_m_s2[0].worst, before.accel_m_s2[0].worst);
  EXPECT_EQ(report().gyro_rad_s[1].worst, before.gyro_rad_s[1].worst);
  run(8, [](LiveCycle& cycle) { cycle.sensors.board.accelerometer = kOnItsSide; });
  EXPECT_EQ(report().state, LiveState::kComparing);
  EXPECT_EQ(resyncs(Resync::kTurned), 1);
  EXPECT_LT(report().accel_m_s2[0].worst, kGravity / 2);
}

TEST(ResidualWindow, WhatIsForgottenCountsNeitherInTheWindowNorInTheWorst) {
  ResidualWindow window{4};
  for (const double residual : {-3.0, 1.0, 2.0, 1.0, 5.0, 7.0}) window.add(residual);
  EXPECT_EQ(window.get().worst, 7);
  window.forgetLast(2);
  EXPECT_EQ(window.get().worst, 3) << "of a value that has left the window";
  EXPECT_EQ(window.get().count, 2);
  window.forgetLast(100);
  EXPECT_EQ(window.get().count, 0);
  EXPECT_EQ(window.get().worst, 3);
}

TEST_F(LiveGaps, ATwinOnTheFloorIsNotPutOnItsSide) {
  LiveComparison floor{modelWith(""), Support::kFloor, kPeriod};
  for (int i = 0; i < 100; ++i) {
    LiveCycle cycle = robot_.next();
    cycle.sensors.board.accelerometer = kOnItsSide;
    floor.take(cycle);
  }
  EXPECT_EQ(floor.report().state, LiveState::kOnItsSide);
  EXPECT_EQ(floor.report().compared, 0);
}

TEST_F(LiveGaps, CyclesThatCountFromOneAgainAreANewRuntime) {
  run(2);
  run(2, [](LiveCycle& cycle) { cycle.sensors.cycle -= 100, cycle.sensors.time_ns -= 1'600'000'000; });
  EXPECT_EQ(resyncs(Resync::kNewRuntime), 1);
  EXPECT_EQ(report().state, LiveState::kComparing);
}

TEST_F(LiveGaps, TheSameCycleAgainHasNoEffect) {
  const LiveCycle cycle = robot_.next();
  comparison_.take(cycle);
  comparison_.take(cycle);
  EXPECT_EQ(report().cycles, 1);
}

TEST_F(LiveGaps, UnknownGainsAreReported) {
  run(0.1);
  EXPECT_TRUE(report().are_gains_known);
  run(0.1, [](LiveCycle& cycle) { cycle.p_gain.fill(kUnknown); });
  EXPECT_FALSE(report().are_gains_known);
}

}  // namespace
}  // namespace darwinop::gap::live::test
