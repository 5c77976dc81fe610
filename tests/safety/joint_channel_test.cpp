// One joint's way from limp to driven.
#include "safety/joint_channel.hpp"

#include <gtest/gtest.h>

namespace darwinop::safety {
namespace {

constexpr Nanos kStep{std::chrono::milliseconds{16}};
constexpr JointRange kElbow{Rad{-1}, Rad{1}};

JointSensors reading(double position) {
  JointSensors s;
  s.motion.received();
  s.position = Rad{position};
  return s;
}

TEST(PositionConfirmer, BelievesTwoReadingsInARowThatAgree) {
  PositionConfirmer c;
  c.update(reading(0.5));
  EXPECT_FALSE(c.confirmed());
  c.update(reading(0.506));
  ASSERT_TRUE(c.confirmed());
  EXPECT_EQ(*c.confirmed(), Rad{0.506});
}

TEST(PositionConfirmer, DoesNotBelieveACorruptedReadingNorTheOneAfterIt) {
  PositionConfirmer c;
  c.update(reading(0.5));
  c.update(reading(2.9));
  EXPECT_FALSE(c.confirmed());
  c.update(reading(0.5));
  EXPECT_FALSE(c.confirmed());
  c.update(reading(0.5));
  EXPECT_TRUE(c.confirmed());
}

TEST(PositionConfirmer, ForgetsWhatIsTooLongAgo) {
  PositionConfirmer c;
  c.update(reading(0.5));
  JointSensors stale = reading(0.5);
  for (int i = 0; i < 6; ++i) {
    stale.motion.missed();
    c.update(stale);
  }
  c.update(reading(0.5));
  EXPECT_FALSE(c.confirmed());
}

TEST(PositionConfirmer, StaleAndUnknownReadingsConfirmNothing) {
  PositionConfirmer c;
  c.update(reading(0.5));
  JointSensors stale = reading(0.5);
  stale.motion.missed();
  c.update(stale);
  EXPECT_FALSE(c.confirmed());
  c.update(reading(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(c.confirmed());
}

TEST(JointChannel, GoesFromOutThroughPresentPoseAndGentleToFree) {
  JointChannel channel;
  EXPECT_TRUE(channel.out());
  channel.restart();
  channel.observe(reading(0.5), kStep);
  EXPECT_FALSE(channel.ready());
  channel.observe(reading(0.5), kStep);
  ASSERT_TRUE(channel.ready());
  EXPECT_FALSE(channel.hasGoal());
  channel.place(kElbow);
  EXPECT_EQ(channel.goal(), Rad{0.5});
  EXPECT_FALSE(channel.moving());
  channel.torqueOn();
  EXPECT_FALSE(channel.advance(Rad{0.875}, 0.125, 0.5)) << "gentle until it has caught up";
  EXPECT_EQ(channel.goal(), Rad{0.625});
  channel.advance(Rad{0.875}, 0.125, 0.5);
  EXPECT_TRUE(channel.advance(Rad{0.875}, 0.125, 0.5));
  EXPECT_TRUE(channel.gentle()) << "the goal is there, the joint is not";
  channel.observe(reading(0.8), kStep);
  EXPECT_TRUE(channel.advance(Rad{0.875}, 0.125, 0.5));
  EXPECT_FALSE(channel.gentle());
  EXPECT_FALSE(channel.advance(Rad{-0.875}, 0.125, 0.5));
  EXPECT_EQ(channel.goal(), Rad{0.375});
}

TEST(JointChannel, AJointThatIsHeldOffItsGoalIsNotGentleForEver) {
  JointChannel channel;
  channel.restart();
  channel.observe(reading(0.5), kStep);
  channel.observe(reading(0.5), kStep);
  channel.place(kElbow);
  channel.torqueOn();
  int cycles = 0;
  for (; channel.gentle(); ++cycles) {
    channel.observe(reading(0.5), kStep);
    (void)channel.advance(Rad{0.875}, 0.125, 0.5);
    ASSERT_LT(cycles, 1000);
  }
  EXPECT_NEAR(cycles * 0.016, 3.0, 0.1);
}

TEST(JointChannel, APoseOutsideTheRangeIsMovedToItsEdge) {
  JointChannel channel;
  channel.restart();
  channel.observe(reading(1.05), kStep);
  channel.observe(reading(1.05), kStep);
  channel.place(kElbow);
  EXPECT_EQ(channel.goal(), Rad{1});
}

TEST(JointChannel, RestartForgetsReadingsFromBefore) {
  JointChannel channel;
  channel.restart();
  channel.observe(reading(0.5), kStep);
  channel.observe(reading(0.5), kStep);
  channel.restart();
  EXPECT_FALSE(channel.ready());
}

TEST(JointChannel, CountsTheTimeItIsDriven) {
  JointChannel channel;
  channel.restart();
  channel.observe(reading(0), kStep);
  channel.observe(reading(0), kStep);
  channel.place(kElbow);
  EXPECT_FALSE(channel.drivenFor());
  channel.torqueOn();
  channel.observe(reading(0), kStep);
  channel.observe(reading(0), kStep);
  EXPECT_EQ(channel.drivenFor(), 2 * kStep);
  channel.leaveOut();
  EXPECT_FALSE(channel.drivenFor());
}

}  // namespace
}  // namespace darwinop::safety
