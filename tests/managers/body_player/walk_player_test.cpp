// WalkPlayer: a walk in SI units for any step length.
#include "managers/body_player/walk_player.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/conversions.hpp"

namespace darwinop::body_player {
namespace {

const GyroReading kUnknownGyro{std::nan(""), std::nan(""), 0};

Pose stance() {
  Pose pose{};
  for (std::size_t i = 0; i < gait::kWalkingJoints; ++i) pose[i] = gait::kStanding.rad(i);
  return pose;
}

class WalkPlayerTest : public testing::Test {
 protected:
  bool advance(double ms, const GyroReading& gyro) { return player_.advance(ms, {.x = 0.5}, true, gyro); }
  void calibrate() {
    for (std::uint64_t cycle = 1; cycle <= gait::GyroCentre::kSamples; ++cycle) advance(8, {512, 512, cycle});
  }

  WalkPlayer player_{gait::Parameters{}};
};

TEST_F(WalkPlayerTest, GivesTheGoalsOfAWalkInTicksOf8Ms) {
  player_.start(stance());
  gait::Walk reference{gait::Parameters{}};
  gait::Pose from{};
  std::copy_n(stance().begin(), from.size(), from.begin());
  reference.start(from);
  int ticks = 0;
  for (double time_ms = 20; time_ms < 4000; time_ms += 20) {
    ASSERT_TRUE(player_.advance(20, {.x = 0.5}, false, kUnknownGyro));
    for (; ticks < static_cast<int>(time_ms / 8); ++ticks) reference.tick({.x = 0.5}, false, {});
    for (std::size_t i = 0; i < gait::kWalkingJoints; ++i)
      ASSERT_EQ(player_.goal(static_cast<Joint>(i)), reference.pose()[i]) << time_ms;
  }
  EXPECT_TRUE(player_.walk().walking());
}

TEST_F(WalkPlayerTest, UsesEachReadingOfTheGyroscopeOnce) {
  for (int i = 0; i < 1000; ++i) advance(16, {512, 512, 7});
  EXPECT_FALSE(player_.walk().isBalanceCalibrated());
  calibrate();
  EXPECT_TRUE(player_.walk().isBalanceCalibrated());
}

TEST_F(WalkPlayerTest, WalksWithoutBalanceIfTheGyroscopeStaysUnknown) {
  player_.start(stance());
  for (int i = 0; i < gait::Walk::kMaxReadings + 10; ++i) advance(16, kUnknownGyro);
  EXPECT_TRUE(player_.walk().walking());
  EXPECT_FALSE(player_.walk().isBalanceCalibrated());
}

TEST_F(WalkPlayerTest, AStartDuringAWalkOnlyCancelsAStop) {
  calibrate();
  player_.start(stance());
  for (int i = 0; i < 100; ++i) advance(16, {512, 512, 1000U + static_cast<unsigned>(i)});
  ASSERT_TRUE(player_.walk().walking());
  player_.stop();
  advance(16, {512, 512, 2000});
  player_.start({});
  for (int i = 0; i < 200; ++i) advance(16, {512, 512, 3000U + static_cast<unsigned>(i)});
  EXPECT_TRUE(player_.walk().walking());
  player_.stop();
  for (int i = 0; i < 200; ++i) advance(16, {512, 512, 4000U + static_cast<unsigned>(i)});
  EXPECT_TRUE(player_.walk().resting());
  EXPECT_FALSE(advance(16, kUnknownGyro)) << "at rest no goal changes";
}

TEST_F(WalkPlayerTest, HasTheGainsOfTheWalk) {
  EXPECT_EQ(player_.pGain(Joint::kLegLowerR), 4);
  EXPECT_EQ(player_.pGain(Joint::kArmLowerR), 1);
}

}  // namespace
}  // namespace darwinop::body_player
