// Lead-in: a page with a distant first pose starts with a smooth motion, other pages start immediately.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/goals/lead_in.hpp"
#include "motion_rig.hpp"

namespace darwinop::webots_api {
namespace {

using managers::DARwInOPMotionManager;

/// A robot whose joints reach their goals in the next cycle.
class GentleStart : public MotionManagerTest {
 protected:
  GentleStart() {
    fake.on_cycle = [this](std::uint64_t) {
      for (std::size_t i = 0; i < kJoints; ++i) {
        const JointCommand& asked = fake.last().joint[i];
        JointSensors& joint = fake.image.joint[i];
        if (asked.has(JointCommand::kGoal)) joint.commanded = joint.position = asked.goal;
      }
    };
  }
  void beAt2000() {
    const auto follow = std::exchange(fake.on_cycle, nullptr);
    for (JointSensors& joint : fake.image.joint) joint.position = joint.commanded = radFromTicks(2000);
    robot().step(16);
    fake.on_cycle = follow;
    fake.published.clear();
  }
  /// Maximum change of all joints in a step of 16 ms, rad, from 2000 ticks.
  double fastest() {
    double most = 0;
    for (std::size_t i = 0; i < kJoints; ++i) {
      double before = radFromTicks(2000).value;
      for (const Commands& image : fake.published) {
        const double now = image.joint[i].goal.value;
        most = std::max(most, std::abs(now - before));
        before = now;
      }
    }
    return most;
  }
};

TEST_F(GentleStart, ADistantPageStartsWithASmoothMotion) {
  pages_[1].step[0].position.fill(2048 + 400);
  pages_[1].step[0].position[19] = motion::kKeep;
  write();
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  manager.step(16);
  robot().step(16);
  for (const int ticks : necks()) EXPECT_EQ(ticks, 2000) << "not part of the first step";
  EXPECT_NEAR(ticksOf(Joint::kHead), 2000, 2) << "the others start at their position";
  int steps = 1;
  for (; manager.isMotionPlaying() && steps < 1000; ++steps) {
    manager.step(16);
    robot().step(16);
  }
  EXPECT_LE(fastest(), goals::LeadIn::kSpeed * 0.016 + 1e-9);
  EXPECT_EQ(ticksOf(Joint::kHead), 2448);
  EXPECT_NEAR(steps * 0.016, 1.5 * 448 * kRadPerTick / goals::LeadIn::kSpeed + 13 * 0.008, 0.032)
      << "followed by the page";
  fake.published.clear();
  manager.playPage(1);
  EXPECT_EQ(fake.published.size(), 7u) << "13 ticks: no lead-in if the robot is in the pose";
}

TEST_F(GentleStart, AFeasibleFirstStepIsUnchanged) {
  // 187 ticks in 80 ms are 3.59 rad/s; with twice the time less than half of the no-load speed.
  pages_[1].step[0].position.fill(2187);
  pages_[2] = pages_[1];
  pages_[2].step[0].time = 20;
  write();
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(2);
  EXPECT_EQ(fake.published.size(), 12u) << "23 ticks of 8 ms";
  beAt2000();
  manager.playPage(1);
  EXPECT_GT(fake.published.size(), 7u + 20u);
}

TEST_F(GentleStart, APageBySpeedIsCheckedByItsSpeed) {
  pages_[1].schedule = motion::kSpeedBased;
  pages_[1].step[0].position.fill(2400);
  pages_[1].step[0].time = 100;  // 1.44 rad/s
  write();
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1);
  const std::size_t slow = fake.published.size();
  EXPECT_EQ(slow, (40u * 400 / 300 + 3 + 1) / 2);
  pages_[1].step[0].time = 255;  // 3.7 rad/s
  write();
  beAt2000();
  DARwInOPMotionManager faster{&robot(), path_};
  faster.playPage(1);
  EXPECT_GT(fake.published.size(), slow);
  EXPECT_LE(fastest(), goals::LeadIn::kSpeed * 0.016 + 1e-9);
}

TEST_F(GentleStart, EndsIfAnotherManagerTakesTheJoints) {
  pages_[1].step[0].position.fill(2448);
  write();
  DARwInOPMotionManager manager{&robot(), path_}, other{manager};
  manager.playPage(1, false);
  manager.step(16);
  robot().step(16);
  other.playPage(2, false);
  manager.step(16);
  EXPECT_FALSE(manager.isMotionPlaying());
  EXPECT_TRUE(other.isMotionPlaying());
}

}  // namespace
}  // namespace darwinop::webots_api
