// PagePlayer: pages in SI units for any step length, with and without a lead-in.
#include "managers/body_player/page_player.hpp"

#include <gtest/gtest.h>

#include "core/conversions.hpp"
#include "managers/motion/first_step.hpp"
#include "managers/motion/pages/own_pages.hpp"
#include "support/find_page.hpp"

namespace darwinop::body_player {
namespace {

Pose poseOf(const motion::Pose& ticks) {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = radFromTicks(ticks[i]).value;
  return pose;
}

/// Pose in front of the walk, from which "hello" starts without a lead-in.
motion::Pose standing(const motion::PageFile& pages) {
  motion::Player player{pages};
  player.start(motion::findPage(pages, "walkready"), motion::Pose{});
  while (player.tick()) continue;
  return player.pose();
}

class PagePlayerTest : public testing::Test {
 protected:
  void expectPose(const motion::Player& played) const {
    for (std::size_t i = 0; i < kJoints; ++i) {
      const auto joint = static_cast<Joint>(i);
      ASSERT_EQ(player_.goal(joint), radFromTicks(played.pose()[i]).value) << i;
      ASSERT_EQ(player_.pGain(joint) * 8, played.pGainRegister(joint)) << i;
    }
  }

  const motion::PageFile& pages_ = motion::ownPages();
  const int hello_ = motion::findPage(pages_, "hello");
  const motion::Pose near_ = standing(pages_);
  PagePlayer player_{pages_};
};

TEST_F(PagePlayerTest, PlaysEveryTickOfANearPageForAnyStepLength) {
  for (const double step_ms : {8.0, 4.0, 16.0, 20.0}) {
    motion::Player reference{pages_};
    ASSERT_TRUE(reference.start(hello_, near_));
    ASSERT_TRUE(player_.start(hello_, poseOf(near_)));
    double time_ms = 0;
    int ticks = 0;
    while (player_.isPlaying()) {
      player_.advance(step_ms);
      time_ms += step_ms;
      for (; ticks < static_cast<int>(time_ms / 8); ++ticks) reference.tick();
      expectPose(reference);
      ASSERT_LT(time_ms, 60'000);
    }
    EXPECT_FALSE(reference.isPlaying());
    EXPECT_GT(ticks, 100);
  }
}

TEST_F(PagePlayerTest, MovesSlowlyToADistantPageFirst) {
  motion::PageFile pages = pages_;
  motion::Page& hello = pages[static_cast<std::size_t>(hello_)];
  hello.step.front().time = 30;  // ticks
  motion::Pose far = near_;
  for (int& ticks : far) ticks += ticks > 2048 ? -1000 : 1000;
  ASSERT_GT(motion::firstStepSpeed(hello, far), motion::kFastestFirstStep);
  Pose before = poseOf(far);
  player_ = PagePlayer{pages};
  ASSERT_TRUE(player_.start(hello_, before));
  motion::Player reference{pages};
  const motion::Pose target = motion::firstTarget(hello, far);
  ASSERT_TRUE(reference.start(hello_, target));
  const goals::LeadIn lead_in{before, poseOf(target)};
  for (int ms = 8; ms < lead_in.durationMs(); ms += 8) {
    ASSERT_TRUE(player_.advance(8));
    for (std::size_t i = 0; i < kJoints; ++i) {
      const double now = player_.goal(static_cast<Joint>(i));
      ASSERT_LE(std::abs(now - before[i]), goals::LeadIn::kSpeed * 0.008 + 1e-9);
      before[i] = now;
    }
  }
  player_.advance(8);
  expectPose(reference);
  while (reference.tick()) {
    ASSERT_TRUE(player_.advance(8));
    expectPose(reference);
  }
  EXPECT_FALSE(player_.advance(8));
  EXPECT_FALSE(player_.isPlaying());
}

TEST_F(PagePlayerTest, StartsOnePageAtATimeAndNoEmptyOne) {
  EXPECT_FALSE(player_.start(0, poseOf(near_)));
  EXPECT_FALSE(player_.start(255, poseOf(near_)));
  EXPECT_FALSE(player_.isPlaying());
  ASSERT_TRUE(player_.start(hello_, poseOf(near_)));
  EXPECT_FALSE(player_.start(hello_, poseOf(near_)));
  player_.brake();
  EXPECT_FALSE(player_.isPlaying());
  EXPECT_FALSE(player_.advance(100));
  EXPECT_TRUE(player_.start(hello_, poseOf(near_)));
}

}  // namespace
}  // namespace darwinop::body_player
