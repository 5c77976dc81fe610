// Motion planner: commands of each cycle for the page's requests.
#include "window/drive/motion_planner.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "managers/motion/pages/own_pages.hpp"
#include "support/find_page.hpp"
#include "window/messages.hpp"

namespace darwinop {
namespace {

constexpr double kCycleMs = 16;

/// A robot that reaches its goals at once and whose gyroscope reads zero.
class WindowMotionPlanner : public testing::Test {
 protected:
  WindowMotionPlanner() {
    seen_.safety.state = State::kDriven;
    seen_.board.motion.received();
    for (auto& axis : seen_.board.gyro) axis = RadPerSec{0};
    for (std::size_t i = 0; i < kJoints; ++i) {
      seen_.joint[i].motion.received();
      put(i, radFromTicks(i < gait::kWalkingJoints ? gait::kStanding.tick[i] : kJointTable[i].start).value);
    }
  }
  void put(std::size_t joint, double rad) {
    seen_.joint[joint].position = seen_.joint[joint].commanded = Rad{rad};
    seen_.joint[joint].driven = true;
  }
  /// One cycle. Returns the number of joints whose command has changed.
  std::size_t turn(const window::DriveRequests& requests = {}) {
    ++seen_.cycle;
    const Commands before = commands_;
    commands_ = planner_.plan(requests, seen_, kCycleMs);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < kJoints; ++i) {
      const JointCommand& now = commands_.joint[i];
      if (!isSame(now, before.joint[i])) ++changed;
      if (!now.has(JointCommand::kGoal) || isLimp(static_cast<Joint>(i))) continue;
      fastest_ = std::max(fastest_, std::abs(now.goal.value - seen_.joint[i].position.value) / kCycleMs * 1000);
      put(i, now.goal.value);
    }
    return changed;
  }
  /// Fields that are not set are compared also.
  static bool isSame(const JointCommand& a, const JointCommand& b) {
    const auto equal = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return a.set == b.set && a.torque_on == b.torque_on && equal(a.goal.value, b.goal.value) &&
           equal(a.speed_limit.value, b.speed_limit.value) && equal(a.torque_limit.value, b.torque_limit.value) &&
           equal(a.p_gain, b.p_gain);
  }
  [[nodiscard]] const JointCommand& command(Joint joint) const { return commands_.joint[index(joint)]; }
  [[nodiscard]] bool isLimp(Joint joint) const {
    return command(joint).has(JointCommand::kTorque) && !command(joint).torque_on;
  }
  static window::DriveRequests forwards() { return {.walk = gait::WalkCommand{.x = 0.5}}; }
  void falls() {
    for (std::size_t i = 0; i < kFaults; ++i) seen_.safety.active[i] = kFaultTable[i].fault == Fault::kFell;
  }
  static window::DriveRequests pageOf(int page) { return {.page = page}; }
  [[nodiscard]] double knee() const { return seen_.joint[index(Joint::kLegLowerR)].position.value; }

  Sensors seen_{};
  window::MotionPlanner planner_{motion::ownPages()};
  Commands commands_{};
  double fastest_ = 0;  // rad/s, of goals
};

TEST_F(WindowMotionPlanner, CommandsASlidersGoalInRadWithASpeedUntilItChanges) {
  window::DriveRequests requests;
  requests.goals[index(Joint::kNeck)] = Rad{0.3};
  requests.goals[index(Joint::kHead)] = Rad{-1e300};
  EXPECT_EQ(turn(requests), 2U);
  EXPECT_EQ(command(Joint::kNeck).goal.value, 0.3);
  EXPECT_EQ(command(Joint::kNeck).speed_limit.value, window::MotionPlanner::kSliderSpeed);
  EXPECT_EQ(command(Joint::kHead).goal.value, -kPi) << "at most half a turn";
  EXPECT_EQ(turn(), 0U);
  EXPECT_EQ(command(Joint::kNeck).goal.value, 0.3);
}

TEST_F(WindowMotionPlanner, WalksWhileRequestedThenStandsWithDefaultGains) {
  for (int i = 0; i < 130; ++i) (void)turn();  // calibrates the gyroscope's zero
  const double standing = knee();
  double most = standing;
  for (int i = 0; i < 190; ++i) {
    (void)turn(forwards());
    most = std::max(most, knee());
  }
  EXPECT_TRUE(planner_.status().walks);
  EXPECT_GT(most, standing + 0.2) << "the feet are lifted";
  EXPECT_LT(fastest_, 12.5) << "no goal jumps";
  EXPECT_EQ(command(Joint::kLegLowerR).p_gain, 4) << "32 in the register, as by default";
  EXPECT_EQ(command(Joint::kArmLowerR).p_gain, 1) << "compliant arms";
  for (int i = 0; i < 100 && planner_.status().walks; ++i) (void)turn();
  EXPECT_FALSE(planner_.status().walks);
  EXPECT_NEAR(knee(), standing, 0.03);
  for (const JointCommand& joint : commands_.joint) EXPECT_EQ(joint.p_gain, 4);
}

TEST_F(WindowMotionPlanner, TheRobotsDefaultGainIsBackAfterAPage) {
  seen_.safety.default_p_gain = 2;
  (void)turn(pageOf(motion::findPage(motion::ownPages(), "hello")));
  for (int i = 0; i < 2000 && planner_.status().page != 0; ++i) (void)turn();
  for (const JointCommand& joint : commands_.joint) EXPECT_EQ(joint.p_gain, 2);
}

TEST_F(WindowMotionPlanner, MovesSlowlyToTheStanceBeforeItWalks) {
  for (std::size_t i = 0; i < kJoints; ++i) put(i, radFromTicks(kJointTable[i].start).value);
  for (int i = 0; i < 100; ++i) (void)turn(forwards());
  EXPECT_LT(fastest_, 1.2);
  EXPECT_TRUE(planner_.status().walks);
}

TEST_F(WindowMotionPlanner, PlaysAPageToItsEndAndIgnoresSlidersMeanwhile) {
  const int hello = motion::findPage(motion::ownPages(), "hello");
  ASSERT_GT(hello, 0);
  window::DriveRequests requests;
  requests.page = hello;
  (void)turn(requests);
  EXPECT_EQ(planner_.status().page, hello);
  window::DriveRequests slider;
  slider.goals[index(Joint::kNeck)] = Rad{1.0};
  int cycles = 0;
  for (; planner_.status().page != 0 && cycles < 2000; ++cycles) (void)turn(slider);
  EXPECT_GT(cycles, 20);
  EXPECT_LT(cycles, 2000);
  EXPECT_LT(std::abs(seen_.joint[index(Joint::kNeck)].position.value), 0.9);
}

TEST_F(WindowMotionPlanner, ALimpLimbHasNoGoalsAndResumesAtItsPosition) {
  window::DriveRequests off, on, slider;
  off.torque[1] = false;
  on.torque[1] = true;
  slider.goals[index(Joint::kArmLowerL)] = Rad{-0.5};
  EXPECT_EQ(turn(off), 3U);
  for (const Joint joint : {Joint::kShoulderL, Joint::kArmUpperL, Joint::kArmLowerL}) EXPECT_TRUE(isLimp(joint));
  EXPECT_EQ(turn(slider), 0U);
  (void)turn(forwards());
  EXPECT_FALSE(planner_.status().walks);
  EXPECT_EQ(planner_.status().refused, window::messages::kWalkRequiresTorque);

  seen_.joint[index(Joint::kArmLowerL)].position = Rad{0.7};
  EXPECT_EQ(turn(on), 3U);
  EXPECT_EQ(planner_.status().refused, "");
  EXPECT_FALSE(isLimp(Joint::kArmLowerL));
  EXPECT_EQ(command(Joint::kArmLowerL).goal.value, 0.7);
  EXPECT_EQ(command(Joint::kArmLowerL).torque_limit.value, kMaxTorqueNm);
}

TEST_F(WindowMotionPlanner, RefusesTorqueAndPagesDuringAWalk) {
  (void)turn(forwards());
  window::DriveRequests both = forwards();
  both.torque[4] = false;
  (void)turn(both);
  EXPECT_TRUE(planner_.status().limp.none());
  both = forwards();
  both.page = 9;
  (void)turn(both);
  EXPECT_EQ(planner_.status().page, 0);
  EXPECT_EQ(planner_.status().refused, window::messages::kPageRequiresRest);
}

TEST_F(WindowMotionPlanner, StartsNoMotionBeforeTheRobotFollows) {
  seen_.safety.state = State::kTakingOver;
  (void)turn(pageOf(9));
  EXPECT_EQ(planner_.status().page, 0);
  EXPECT_EQ(planner_.status().refused, window::messages::kRobotDoesNotFollow);
  EXPECT_EQ(turn(forwards()), 0U);
  seen_.safety.state = State::kDriven;
  (void)turn(forwards());
  EXPECT_TRUE(planner_.status().walks);
}

TEST_F(WindowMotionPlanner, AbortsAPageThatTheRobotDoesNotFollow) {
  for (int i = 0; i < 10; ++i) (void)turn(i == 0 ? pageOf(9) : window::DriveRequests{});
  EXPECT_EQ(planner_.status().page, 9);
  seen_.safety.state = State::kHolding;
  for (int i = 0; i < 10; ++i) (void)turn();
  EXPECT_EQ(planner_.status().page, 9) << "a short interruption does not end it";
  for (int i = 0; i < 20; ++i) (void)turn();
  EXPECT_EQ(planner_.status().page, 0);
  EXPECT_EQ(planner_.status().refused, window::messages::kMotionAborted);
  seen_.safety.state = State::kDriven;
  EXPECT_EQ(turn(), 0U);
}

TEST_F(WindowMotionPlanner, AbortsAWalkThatTheRobotDoesNotFollowUntilItIsRequestedAgain) {
  for (int i = 0; i < 20; ++i) (void)turn(forwards());
  seen_.safety.state = State::kOffline;
  for (int i = 0; i < 30; ++i) (void)turn(forwards());
  EXPECT_FALSE(planner_.status().walks);
  seen_.safety.state = State::kDriven;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(turn(forwards()), 0U);
  EXPECT_EQ(planner_.status().refused, window::messages::kMotionAborted);
  (void)turn();
  (void)turn(forwards());
  EXPECT_TRUE(planner_.status().walks);
}

TEST_F(WindowMotionPlanner, AWalkDoesNotStartWhenAPageEnds) {
  const int hello = motion::findPage(motion::ownPages(), "hello");
  (void)turn(pageOf(hello));
  for (int i = 0; i < 2000 && planner_.status().page != 0; ++i) {
    (void)turn(forwards());
    EXPECT_EQ(planner_.status().refused, window::messages::kPageIsPlaying);
  }
  for (int i = 0; i < 5; ++i) (void)turn(forwards());
  EXPECT_FALSE(planner_.status().walks);
}

TEST_F(WindowMotionPlanner, PlaysGetUpPagesOnlyForAFallenRobot) {
  for (int i = 0; i < 20; ++i) (void)turn(forwards());
  falls();
  (void)turn(forwards());
  EXPECT_FALSE(planner_.status().walks);
  (void)turn();
  (void)turn(forwards());
  EXPECT_FALSE(planner_.status().walks);
  (void)turn(pageOf(9));
  EXPECT_EQ(planner_.status().page, 0);
  (void)turn(pageOf(10));
  EXPECT_EQ(planner_.status().page, 10);
}

TEST_F(WindowMotionPlanner, RefusesAGetUpPageForAStandingRobot) {
  for (const int page : {10, 11}) {
    ASSERT_TRUE(motion::ownPages()[static_cast<std::size_t>(page)].nameText().ends_with(" up"));
    (void)turn(pageOf(page));
    EXPECT_EQ(planner_.status().page, 0);
    EXPECT_EQ(planner_.status().refused, window::messages::kPageRequiresAFall);
  }
}

TEST_F(WindowMotionPlanner, WithdrawingAWalkBeforeTheStanceHoldsTheRobotThere) {
  for (std::size_t i = 0; i < kJoints; ++i) put(i, radFromTicks(kJointTable[i].start).value);
  for (int i = 0; i < 40; ++i) (void)turn(forwards());
  const double before = knee();
  (void)turn();
  EXPECT_FALSE(planner_.status().walks);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(turn(), 0U);
  EXPECT_EQ(knee(), before);
}

TEST_F(WindowMotionPlanner, ALimbWithoutAKnownPositionStaysLimp) {
  window::DriveRequests off, on;
  off.torque[1] = false;
  on.torque[1] = true;
  (void)turn(off);
  seen_.joint[index(Joint::kArmLowerL)].motion.age = 100;
  EXPECT_EQ(turn(on), 0U);
  EXPECT_TRUE(planner_.status().limp[1]);
  EXPECT_THAT(planner_.status().refused, testing::HasSubstr("ArmLowerL reports no position"));
}

}  // namespace
}  // namespace darwinop
