// What effects do to a command and to the reading of the encoder.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "twin/effects/rig.hpp"

namespace darwinop::twin {
namespace {

constexpr double kPeriod = 0.001;

/// The set point, period by period, of a servo whose horn stands at 0 while the goal jumps in the first period.
std::vector<double> setPointsAfterStep(Servo& servo, double goal, int periods) {
  servo.reset(0);
  servo.firmware(driveTo(0), 0, 0);
  std::vector<double> seen;
  for (int i = 0; i < periods; ++i) {
    servo.firmware(driveTo(goal), 0, 0);
    seen.push_back(servo.signals().set_point_rad);
  }
  return seen;
}

TEST(TransportDelay, LetsAGoalActLaterByExactlyItsPeriods) {
  for (int periods = 0; periods <= 80; ++periods) {
    Servo servo = servoWith({{"transport_delay", {{"delay", periods / 1000.0}}}});
    const auto seen = setPointsAfterStep(servo, 1, 90);
    for (int i = 0; i < 90; ++i) EXPECT_EQ(seen[static_cast<std::size_t>(i)], i < periods ? 0 : 1) << periods;
  }
}

TEST(TransportDelay, TakesThePartOfAPeriodFromBothNeighbours) {
  Servo servo = servoWith({{"transport_delay", {{"delay", 2.25 * kPeriod}}}});
  const auto seen = setPointsAfterStep(servo, 1, 4);
  EXPECT_EQ(seen[1], 0);
  EXPECT_NEAR(seen[2], 0.75, 1e-12);
  EXPECT_EQ(seen[3], 1);
}

TEST(TransportDelay, HoldsItsLongestDelayAtAFirmwareTenTimesAsFast) {
  ServoParameters fast;
  fast.firmware_period_s = 0.0001;
  Servo servo = servoWith({{"transport_delay", {{"delay", 0.08}}}}, fast);
  const auto seen = setPointsAfterStep(servo, 1, 810);
  EXPECT_EQ(seen[799], 0);
  EXPECT_EQ(seen[800], 1);
}

TEST(TransportDelay, LetsTorqueOffActAtOnce) {
  Servo servo = servoWith({{"transport_delay", {{"delay", 0.03}}}});
  setPointsAfterStep(servo, 1, 50);
  ServoDrive off = driveTo(1);
  off.torque_on = false;
  servo.firmware(off, 0, 0);
  EXPECT_FALSE(servo.signals().torque_on);
  EXPECT_EQ(servo.signals().duty, 0);
}

TEST(TransportDelay, MakesTheReadingsOld) {
  Servo servo = servoWith({{"transport_delay", {{"reading", 5 * kPeriod}}}});
  const double tick = 2 * std::numbers::pi / 4096;
  for (int i = 1; i <= 20; ++i) {
    servo.firmware(driveTo(0), i * tick, 0);
    EXPECT_NEAR(servo.signals().measured_rad, std::max(0, i - 5) * tick, 1e-12);
  }
}

/// Set points of a servo that gets a new goal every 16 ms; true: the goal of that packet never acted.
std::vector<bool> lostPackets(double loss, double seed, int packets) {
  Servo servo = servoWith({{"lost_packets", {{"loss", loss}, {"seed", seed}}}});
  std::vector<bool> lost;
  double before = 0;
  for (int k = 1; k <= packets; ++k) {
    for (int i = 0; i < 16; ++i) {
      servo.firmware(driveTo(k), 0, 0);
      const double now = servo.signals().goal_rad;
      EXPECT_TRUE(now == k || now == before) << "a goal that nobody sent";
    }
    lost.push_back(servo.signals().goal_rad != k);
    before = servo.signals().goal_rad;
  }
  return lost;
}

TEST(LostPackets, LosesItsShareOfThem) {
  const auto lost = lostPackets(0.2, 1, 4000);
  // Four standard deviations of a binomial count: sqrt(4000 0.2 0.8) = 25.
  EXPECT_NEAR(static_cast<double>(std::ranges::count(lost, true)), 800, 100);
}

TEST(LostPackets, LosesOthersForAnotherSeedAndTheSameForTheSame) {
  EXPECT_EQ(lostPackets(0.2, 7, 200), lostPackets(0.2, 7, 200));
  EXPECT_NE(lostPackets(0.2, 7, 200), lostPackets(0.2, 8, 200));
}

// The host writes a goal again in every cycle, so that a lost one comes 16 ms later.
TEST(LostPackets, AreMadeGoodByTheNextOne) {
  Servo servo = servoWith({{"lost_packets", {{"loss", 0.2}}}});
  int late = 0;
  for (int k = 1; k <= 200; ++k) {
    int periods = 0;
    do {
      servo.firmware(driveTo(k), 0, 0);
      ++periods;
    } while (servo.signals().goal_rad != k && periods < 1000);
    EXPECT_EQ((periods - 1) % 16, 0) << "acts when a packet arrives, never between two";
    EXPECT_LT(periods, 130) << "eight losses in a row at 20 % have a chance of 3 in a million";
    late += periods > 1 ? 1 : 0;
    for (int i = 0; i < 400; ++i) servo.firmware(driveTo(k), 0, 0);
  }
  EXPECT_GT(late, 10);
}

TEST(LostPackets, JitterMakesSomeLateAndNoneEarly) {
  Servo servo = servoWith({{"lost_packets", {{"jitter", 0.003}}}});
  double sum = 0;
  for (int k = 1; k <= 1000; ++k) {
    int late = -1;
    for (int i = 0; i < 16; ++i) {
      servo.firmware(driveTo(k), 0, 0);
      if (late < 0 && servo.signals().goal_rad == k) late = i;
    }
    EXPECT_GE(late, 0);
    sum += late;
  }
  // Mean of |N(0, 3 ms)| is 2.39 ms; 1000 draws are within 0.06 ms of it, one sigma.
  EXPECT_NEAR(sum / 1000, 2.39, 0.25);
}

TEST(GearScale, ScalesTheGoal) {
  Servo servo = servoWith({{"gear_scale", {{"scale", 0.95}}}});
  EXPECT_NEAR(setPointsAfterStep(servo, 1.2, 3).back(), 1.14, 1e-12);
}

TEST(SpeedLimit, MakesARampOfOneSlopeWhateverTheStep) {
  for (const double size : {0.4, 1.0, -1.6}) {
    Servo servo = servoWith({{"speed_limit", {{"speed", 2}}}});
    const auto seen = setPointsAfterStep(servo, size, 1000);
    const auto arrived = std::ranges::find_if(seen, [&](double at) { return std::abs(at - size) < 1e-9; });
    EXPECT_NEAR(static_cast<double>(arrived - seen.begin()), 1000 * std::abs(size) / 2, 1.5);
    EXPECT_NEAR(seen[99], std::copysign(0.2, size), 1e-9);
  }
}

TEST(SpeedLimit, LeavesALowerLimitOfTheRegisterAlone) {
  Servo servo = servoWith({{"speed_limit", {{"speed", 2}}}});
  ServoDrive slow = driveTo(1);
  slow.speed_limit_rad_s = 0.5;
  for (int i = 0; i < 100; ++i) servo.firmware(slow, 0, 0);
  EXPECT_NEAR(servo.signals().set_point_rad, 0.05, 1e-9);
}

TEST(SpeedLimit, LimitsTheMotorItselfUnderTheLawOfWebots) {
  ServoParameters webots;
  webots.law = Law::kSpeedP;
  Servo servo = servoWith({{"speed_limit", {{"speed", 2}}}}, webots);
  servo.firmware(driveTo(1), 0, 0);
  EXPECT_NEAR(servo.signals().speed_command_rad_s, 2, 1e-12);
}

TEST(AccelLimit, TakesATimeThatGrowsWithTheRootOfTheStep) {
  for (const double size : {0.2, 0.8, -1.8}) {
    Servo servo = servoWith({{"accel_limit", {{"accel", 20}}}});
    const auto seen = setPointsAfterStep(servo, size, 1000);
    const auto arrived = std::ranges::find_if(seen, [&](double at) { return std::abs(at - size) < 1e-9; });
    // Speeding up half of the way and braking the other half; whole periods add one or two.
    EXPECT_NEAR(static_cast<double>(arrived - seen.begin()), 2000 * std::sqrt(std::abs(size) / 20), 3);
    for (std::size_t i = 2; i < seen.size(); ++i)
      ASSERT_LE(std::abs(seen[i] - 2 * seen[i - 1] + seen[i - 2]) / (kPeriod * kPeriod), 20 * (1 + 1e-6)) << i;
  }
}

TEST(EncoderQuantisation, PutsReadingsOnItsGrid) {
  Servo servo = servoWith({{"encoder_quantisation", {{"ticks", 1024}}}});
  const double tick = 2 * std::numbers::pi / 1024;
  for (int i = 0; i < 500; ++i) {
    const double at = 0.0007 * i;
    servo.firmware(driveTo(0), at, 0);
    const double read = servo.signals().measured_rad;
    EXPECT_NEAR(std::remainder(read, tick), 0, 1e-12);
    EXPECT_LE(std::abs(read - at), tick / 2 + 1e-12);
  }
}

}  // namespace
}  // namespace darwinop::twin
