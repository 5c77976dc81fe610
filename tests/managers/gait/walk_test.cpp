// A whole walk: the gentle way to the stance, standing still for the gyroscope, steps, rest.
#include "managers/gait/walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace darwinop::gait {
namespace {

constexpr double kSilent = std::numeric_limits<double>::quiet_NaN();
constexpr GyroCounts kLevel{512, 512};

const Pose kStance = poseOf(kStanding);

Pose sitting() {
  Pose pose{};
  for (std::size_t i = 0; i < kWalkingJoints; ++i) pose[i] = radFromTicks(kJointTable[i].start).value;
  return pose;
}

double greatestStep(const Pose& a, const Pose& b) {
  double greatest = 0;
  for (std::size_t i = 0; i < kWalkingJoints; ++i) greatest = std::max(greatest, std::abs(a[i] - b[i]));
  return greatest;
}

/// Ticks until the first step, at most 2000.
int ticksToWalk(Walk& walk, bool balance, const GyroCounts& gyro) {
  int ticks = 0;
  for (; !walk.walking() && ticks < 2000; ++ticks) walk.tick({}, balance, gyro);
  return ticks;
}

TEST(Approach, GoesGentlyFromSittingToTheStance) {
  Approach approach{sitting(), kStance};
  EXPECT_NEAR(approach.durationMs(), 2675, 1);
  Pose last = sitting();
  while (!approach.done()) {
    const Pose next = approach.next();
    EXPECT_LT(greatestStep(last, next) / 0.008, 1.5 * Approach::kSpeed + 1e-9);
    last = next;
  }
  EXPECT_EQ(last, kStance);
}

TEST(Approach, TakesNoTimeWhenTheRobotIsThere) {
  Pose almost = kStance;
  almost[3] += 0.04;
  almost[7] = kSilent;
  EXPECT_TRUE((Approach{almost, kStance}.done()));
  Pose unknown;
  unknown.fill(kSilent);
  EXPECT_TRUE((Approach{unknown, kStance}.done()));
}

TEST(GyroCentre, IsTheMeanOfARobotThatStandsStill) {
  std::mt19937 dice{7};
  std::normal_distribution<double> noise{0, 1};
  GyroCentre centre;
  for (int i = 0; i < GyroCentre::kSamples; ++i) {
    EXPECT_FALSE(centre.known());
    EXPECT_FALSE(centre.tilt(512, 512).roll == 0);
    centre.add(508 + noise(dice), 516 + noise(dice));
    centre.add(kSilent, 512);
  }
  ASSERT_TRUE(centre.known());
  EXPECT_NEAR(centre.tilt(518, 506).roll, 10, 0.5);
  EXPECT_NEAR(centre.tilt(518, 506).pitch, -10, 0.5);
}

TEST(GyroCentre, IsNotThatOfARobotThatIsMoved) {
  GyroCentre centre;
  for (int i = 0; i < 10 * GyroCentre::kSamples; ++i) centre.add(512 + (i % 2 == 0 ? 2.1 : -2.1), 512);
  EXPECT_FALSE(centre.known());
  for (int i = 0; i < 10 * GyroCentre::kSamples; ++i) centre.add(512, 512 + (i % 2 == 0 ? 2.1 : -2.1));
  EXPECT_FALSE(centre.known());
  for (int i = 0; i < GyroCentre::kSamples; ++i) centre.add(512 + (i % 2 == 0 ? 1.9 : -1.9), 512);
  EXPECT_TRUE(centre.known());
}

TEST(Walk, WithoutBalanceStepsAtOnce) {
  Walk walk{Parameters{}};
  walk.start(kStance);
  EXPECT_EQ(ticksToWalk(walk, false, kLevel), 1);
  EXPECT_EQ(walk.pose(), kStance);  // the engine's first call
}

TEST(Walk, StandsStillForTheGyroscopeOnce) {
  Walk walk{Parameters{}};
  walk.start(kStance);
  EXPECT_EQ(ticksToWalk(walk, true, kLevel), GyroCentre::kSamples + 1);
  walk.stop();
  while (!walk.resting()) walk.tick({}, true, kLevel);
  walk.start(walk.pose());
  EXPECT_EQ(ticksToWalk(walk, true, kLevel), 1);
}

TEST(Walk, LearnsTheCentreWhileItRests) {
  Walk walk{Parameters{}};
  for (int i = 0; i < GyroCentre::kSamples; ++i) walk.tick({}, true, kLevel);
  EXPECT_TRUE(walk.knowsBalance());
  walk.start(kStance);
  EXPECT_EQ(ticksToWalk(walk, true, kLevel), 1);
}

TEST(Walk, TakesEveryReadingOfTheGyroscopeOnce) {
  Walk walk{Parameters{}};
  walk.start(kStance);
  int ticks = 0;
  for (; !walk.walking() && ticks < 2000; ++ticks) walk.tick({}, true, {512, 512, ticks % 2 == 0});
  EXPECT_EQ(ticks, 2 * GyroCentre::kSamples) << "of a robot that is read every 16 ms";
}

TEST(Walk, GoesToAFarStrideAtTheSpeedOfServos) {
  Engine engine{Parameters{}};
  Walk walk{Parameters{}};
  engine.start();
  walk.start(kStance);
  ticksToWalk(walk, false, kLevel);
  engine.next({0, 1, 0, false}, {kSilent, kSilent});
  int late = 0;
  double fastest = 0;
  for (int tick = 1; tick < 225; ++tick) {
    const Pose before = walk.pose();
    walk.tick({0, 1, 0, false}, false, kLevel);
    fastest = std::max(fastest, greatestStep(before, walk.pose()) / 0.008);
    if (walk.pose() != poseOf(engine.next({0, 1, 0, false}, {kSilent, kSilent}))) ++late;
  }
  EXPECT_NEAR(fastest, 12.26, 1e-9) << "the feet open in a single call of the engine";
  EXPECT_EQ(late, 1) << "of all other calls not one was changed";
}

TEST(Walk, ForgetsSamplesOfAnotherStance) {
  Walk walk{Parameters{}};
  for (int i = 0; i < 60; ++i) walk.tick({}, true, {511, 511});
  walk.start(kStance);
  EXPECT_EQ(ticksToWalk(walk, true, kLevel), GyroCentre::kSamples + 1);
}

TEST(Walk, WalksWithoutBalanceWhenItCannotCalibrate) {
  Walk walk{Parameters{}}, blind{Parameters{}}, unbalanced{Parameters{}};
  for (Walk* one : {&walk, &blind, &unbalanced}) one->start(kStance);
  int ticks = 0;
  for (; !walk.walking() && ticks < 1000; ++ticks) walk.tick({1, 0, 0, false}, true, {512.0 + 40 * (ticks % 2), 512});
  EXPECT_EQ(ticks, 3 * GyroCentre::kSamples + 1);
  EXPECT_EQ(ticksToWalk(blind, true, {kSilent, kSilent}), 3 * GyroCentre::kSamples + 1);
  ticksToWalk(unbalanced, false, kLevel);
  for (int i = 0; i < 200; ++i) {
    for (Walk* one : {&walk, &blind, &unbalanced}) one->tick({1, 0, 0, false}, one != &unbalanced, {600, 300});
    ASSERT_EQ(walk.pose(), unbalanced.pose());
    ASSERT_EQ(blind.pose(), unbalanced.pose());
  }
}

TEST(Walk, EndsInTheStanceWhateverTheGyroscopeSaysLast) {
  Walk walk{Parameters{}};
  walk.start(kStance);
  ticksToWalk(walk, true, kLevel);
  for (int i = 0; i < 130; ++i) walk.tick({1, 0, 0, false}, true, {520, 500});
  walk.stop();
  int ticks = 0;
  for (; !walk.resting() && ticks < 1000; ++ticks) walk.tick({1, 0, 0, false}, true, {520, 500});
  EXPECT_LE(ticks, 113);  // one and a half periods
  EXPECT_EQ(walk.pose(), kStance);
  walk.tick({1, 0, 0, false}, true, {520, 500});
  EXPECT_EQ(walk.pose(), kStance);
}

TEST(Walk, AStopOnTheWayToTheStanceEndsThere) {
  Walk walk{Parameters{}};
  walk.start(sitting());
  for (int i = 0; i < 50; ++i) walk.tick({}, true, kLevel);
  walk.stop();
  int ticks = 0;
  for (; !walk.resting() && ticks < 1000; ++ticks) walk.tick({}, true, kLevel);
  EXPECT_NEAR(ticks * kTickMs, 2675 - 50 * kTickMs, 20);
  EXPECT_EQ(walk.pose(), kStance);
}

TEST(Walk, AStartTakesAStopBack) {
  Walk walk{Parameters{}};
  walk.start(kStance);
  ticksToWalk(walk, false, kLevel);
  walk.stop();
  walk.start(walk.pose());
  for (int i = 0; i < 300; ++i) walk.tick({}, false, kLevel);
  EXPECT_TRUE(walk.walking());
}

}  // namespace
}  // namespace darwinop::gait
