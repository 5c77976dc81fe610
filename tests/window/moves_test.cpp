// What is said to the robot each cycle because of an order.
#include "window/moves.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "managers/motion/pages/own_pages.hpp"
#include "remote/protocol/units.hpp"

namespace darwinop {
namespace {

constexpr double kCycleMs = 16;

/// A robot that is where it is asked to be, and stands as still as its gyroscope.
class WindowMoves : public testing::Test {
 protected:
  WindowMoves() {
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
  remote::Request turn(const window::Orders& orders = {}) {
    ++seen_.cycle;
    remote::Request request = moves_.turn(orders, seen_, kCycleMs);
    for (const remote::MotorSetting& setting : request.motors) {
      if (!setting.has(remote::MotorSetting::kPosition)) continue;
      const double rad = remote::positionFromWire(setting.position);
      fastest_ = std::max(fastest_, std::abs(rad - seen_.joint[index(setting.joint)].position.value) / kCycleMs * 1000);
      put(index(setting.joint), rad);
    }
    return request;
  }
  static window::Orders forwards() { return {.walk = gait::Wish{.x = 0.5}}; }
  void falls() {
    for (std::size_t i = 0; i < kFaults; ++i) seen_.safety.active[i] = kFaultTable[i].fault == Fault::kFell;
  }
  static window::Orders pageOf(int page) { return {.page = page}; }
  [[nodiscard]] double knee() const { return seen_.joint[index(Joint::kLegLowerR)].position.value; }

  Sensors seen_{};
  window::Moves moves_{motion::ownPages()};
  double fastest_ = 0;  // rad/s, of goals
};

TEST_F(WindowMoves, AGoalIsSaidOnceWithASpeedAndWithinWhatAnEncoderKnows) {
  window::Orders orders;
  orders.goals[index(Joint::kNeck)] = Rad{0.3};
  orders.goals[index(Joint::kHead)] = Rad{-1e300};
  const remote::Request request = turn(orders);
  ASSERT_EQ(request.motors.size(), 2U);
  EXPECT_NEAR(remote::positionFromWire(request.motors[0].position), 0.3, 0.001);
  EXPECT_NEAR(remote::velocityFromWire(request.motors[0].velocity), window::Moves::kFastest, 0.02);
  EXPECT_TRUE(remote::isEncoderPosition(request.motors[1].position));
  EXPECT_TRUE(turn().motors.empty());
}

TEST_F(WindowMoves, WalksWhileItIsWantedThenStandsWithItsUsualGains) {
  for (int i = 0; i < 130; ++i) (void)turn();  // it learns where the gyroscope rests
  const double standing = knee();
  double most = standing;
  for (int i = 0; i < 190; ++i) {
    (void)turn(forwards());
    most = std::max(most, knee());
  }
  EXPECT_TRUE(moves_.doings().walks);
  EXPECT_GT(most, standing + 0.2) << "it lifts its feet";
  EXPECT_LT(fastest_, 12.5) << "no goal jumps";
  remote::Request last;
  for (int i = 0; i < 100 && moves_.doings().walks; ++i) last = turn();
  EXPECT_FALSE(moves_.doings().walks);
  EXPECT_NEAR(knee(), standing, 0.03);
  ASSERT_EQ(last.motors.size(), kJoints);
  for (const remote::MotorSetting& setting : last.motors) EXPECT_EQ(remote::gainFromWire(setting.pid[0]), 4.0);
}

TEST_F(WindowMoves, GetsUpGentlyFromWhereverItIsBeforeItWalks) {
  for (std::size_t i = 0; i < kJoints; ++i) put(i, radFromTicks(kJointTable[i].start).value);
  for (int i = 0; i < 100; ++i) (void)turn(forwards());
  EXPECT_LT(fastest_, 1.2);
  EXPECT_TRUE(moves_.doings().walks);
}

TEST_F(WindowMoves, ThePageIsPlayedToItsEndAndSlidersWaitMeanwhile) {
  const int hello = motion::findPage(motion::ownPages(), "hello");
  ASSERT_GT(hello, 0);
  window::Orders orders;
  orders.page = hello;
  (void)turn(orders);
  EXPECT_EQ(moves_.doings().page, hello);
  window::Orders slider;
  slider.goals[index(Joint::kNeck)] = Rad{1.0};
  int cycles = 0;
  for (; moves_.doings().page != 0 && cycles < 2000; ++cycles) (void)turn(slider);
  EXPECT_GT(cycles, 20);
  EXPECT_LT(cycles, 2000);
  EXPECT_LT(std::abs(seen_.joint[index(Joint::kNeck)].position.value), 0.9);
}

TEST_F(WindowMoves, ALimpLimbHasNoGoalsAndBeginsAgainWhereItHangs) {
  window::Orders off, on, slider;
  off.torque[1] = false;
  on.torque[1] = true;
  slider.goals[index(Joint::kArmLowerL)] = Rad{-0.5};
  const remote::Request limp = turn(off);
  ASSERT_EQ(limp.motors.size(), 3U);
  for (const auto& setting : limp.motors) EXPECT_EQ(setting.available_torque, 0);
  EXPECT_TRUE(turn(slider).motors.empty());
  (void)turn(forwards());
  EXPECT_FALSE(moves_.doings().walks);
  EXPECT_THAT(moves_.doings().refused, testing::HasSubstr("torque"));

  seen_.joint[index(Joint::kArmLowerL)].position = Rad{0.7};
  const remote::Request again = turn(on);
  EXPECT_EQ(moves_.doings().refused, "");
  const auto elbow = std::ranges::find(again.motors, Joint::kArmLowerL, &remote::MotorSetting::joint);
  ASSERT_NE(elbow, again.motors.end());
  EXPECT_NEAR(remote::positionFromWire(elbow->position), 0.7, 0.001);
  EXPECT_GT(elbow->available_torque, 0);
}

TEST_F(WindowMoves, NothingGoesLimpAndNoPageBeginsWhileItWalks) {
  (void)turn(forwards());
  window::Orders both = forwards();
  both.torque[4] = false;
  (void)turn(both);
  EXPECT_TRUE(moves_.doings().limp.none());
  both = forwards();
  both.page = 9;
  (void)turn(both);
  EXPECT_EQ(moves_.doings().page, 0);
  EXPECT_THAT(moves_.doings().refused, testing::HasSubstr("stands"));
}

TEST_F(WindowMoves, NothingBeginsBeforeTheRobotFollowsAndAWalkThenDoes) {
  seen_.safety.state = State::kTakingOver;
  (void)turn(pageOf(9));
  EXPECT_EQ(moves_.doings().page, 0);
  EXPECT_THAT(moves_.doings().refused, testing::HasSubstr("does not follow yet"));
  EXPECT_TRUE(turn(forwards()).motors.empty());
  seen_.safety.state = State::kDriven;
  (void)turn(forwards());
  EXPECT_TRUE(moves_.doings().walks);
}

TEST_F(WindowMoves, APageThatTheRobotNoLongerFollowsIsBrokenOffAndDoesNotGoOn) {
  for (int i = 0; i < 10; ++i) (void)turn(i == 0 ? pageOf(9) : window::Orders{});
  EXPECT_EQ(moves_.doings().page, 9);
  seen_.safety.state = State::kHolding;
  for (int i = 0; i < 10; ++i) (void)turn();
  EXPECT_EQ(moves_.doings().page, 9) << "a moment is no end";
  for (int i = 0; i < 20; ++i) (void)turn();
  EXPECT_EQ(moves_.doings().page, 0);
  EXPECT_THAT(moves_.doings().refused, testing::HasSubstr("broken off"));
  seen_.safety.state = State::kDriven;
  EXPECT_TRUE(turn().motors.empty());
}

TEST_F(WindowMoves, AWalkThatTheRobotNoLongerFollowsBeginsAgainOnlyForWhoPressesAgain) {
  for (int i = 0; i < 20; ++i) (void)turn(forwards());
  seen_.safety.state = State::kOffline;
  for (int i = 0; i < 30; ++i) (void)turn(forwards());
  EXPECT_FALSE(moves_.doings().walks);
  seen_.safety.state = State::kDriven;
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(turn(forwards()).motors.empty());
  EXPECT_THAT(moves_.doings().refused, testing::HasSubstr("broken off"));
  (void)turn();
  (void)turn(forwards());
  EXPECT_TRUE(moves_.doings().walks);
}

TEST_F(WindowMoves, AWalkDoesNotBeginByItselfWhenAPageEnds) {
  const int hello = motion::findPage(motion::ownPages(), "hello");
  (void)turn(pageOf(hello));
  for (int i = 0; i < 2000 && moves_.doings().page != 0; ++i) {
    (void)turn(forwards());
    EXPECT_THAT(moves_.doings().refused, testing::HasSubstr("a page is played"));
  }
  for (int i = 0; i < 5; ++i) (void)turn(forwards());
  EXPECT_FALSE(moves_.doings().walks);
}

TEST_F(WindowMoves, AFallenRobotOnlyGetsUpAndAStandingOneDoesNot) {
  for (int i = 0; i < 20; ++i) (void)turn(forwards());
  falls();
  (void)turn(forwards());
  EXPECT_FALSE(moves_.doings().walks);
  (void)turn();
  (void)turn(forwards());
  EXPECT_FALSE(moves_.doings().walks);
  (void)turn(pageOf(9));
  EXPECT_EQ(moves_.doings().page, 0);
  (void)turn(pageOf(10));
  EXPECT_EQ(moves_.doings().page, 10);
}

TEST_F(WindowMoves, APageForARobotThatLiesIsNotPlayedByOneThatStands) {
  for (const int page : {10, 11}) {
    ASSERT_TRUE(motion::ownPages()[static_cast<std::size_t>(page)].nameText().ends_with(" up"));
    (void)turn(pageOf(page));
    EXPECT_EQ(moves_.doings().page, 0);
    EXPECT_THAT(moves_.doings().refused, testing::HasSubstr("lies"));
  }
}

TEST_F(WindowMoves, WhoLetsGoBeforeTheRobotIsOnItsFeetStopsItThere) {
  for (std::size_t i = 0; i < kJoints; ++i) put(i, radFromTicks(kJointTable[i].start).value);
  for (int i = 0; i < 40; ++i) (void)turn(forwards());
  const double before = knee();
  (void)turn();
  EXPECT_FALSE(moves_.doings().walks);
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(turn().motors.empty());
  EXPECT_EQ(knee(), before);
}

TEST_F(WindowMoves, ALimbOfWhichNobodyKnowsWhereItHangsStaysLimp) {
  window::Orders off, on;
  off.torque[1] = false;
  on.torque[1] = true;
  (void)turn(off);
  seen_.joint[index(Joint::kArmLowerL)].motion.age = 100;
  EXPECT_TRUE(turn(on).motors.empty());
  EXPECT_TRUE(moves_.doings().limp[1]);
  EXPECT_THAT(moves_.doings().refused, testing::HasSubstr("ArmLowerL does not tell where it is"));
}

}  // namespace
}  // namespace darwinop
