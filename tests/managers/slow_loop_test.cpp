// Walks in a loop that is slower than its step, and without a call of step() of the manager.
#include <gmock/gmock.h>

#include <cmath>

#include "gait_rig.hpp"
#include "managers/messages.hpp"
#include "managers/step_clock.hpp"

namespace darwinop::webots_api {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::Not;

class SlowLoop : public GaitManager {
 protected:
  /// A loop of published controllers that needs `round` for each step(16).
  void loop(int rounds, milliseconds round) {
    for (int i = 0; i < rounds; ++i) {
      const Nanos start = fake.now;
      manager().step(16);
      robot().step(16);
      if (fake.now - start < round) fake.pass(start + round - fake.now);
    }
  }
  /// Goals of the engine after `ms`.
  static std::array<int, kWalking> walked(int ms) {
    gait::Engine engine{gait::shipped()};
    engine.start();
    for (int call = 0; call < ms / 8; ++call) engine.next({}, {NAN, NAN});
    return engine.goals().tick;
  }
};

TEST_F(SlowLoop, TheWalkKeepsTheRobotsTime) {
  for (const int round_ms : {24, 32, 40, 64, 80}) {
    manager_.reset();
    end();
    standing().start();
    loop(1, milliseconds{16});
    const Nanos begun = fake.now;
    loop(1200 / round_ms, milliseconds{round_ms});
    const auto ms = static_cast<int>((fake.now - begun) / milliseconds{1});
    std::array<int, kWalking> nearest{};
    int at = -1;
    for (int walked_ms = ms - 2 * round_ms; walked_ms <= ms + 16 && at < 0; walked_ms += 8)
      if (walked(walked_ms) == goals()) at = walked_ms, nearest = goals();
    EXPECT_GE(at, 0) << round_ms << ": not where the walk is at that time, within two rounds";
  }
}

TEST_F(SlowLoop, BeyondTheBoundItPlaysInSlowMotion) {
  standing().start();
  loop(1, milliseconds{16});
  loop(5, milliseconds{400});
  // Late rounds show in the image after them.
  const int slow_ms = 3 * 16 + 3 * static_cast<int>(managers::StepClock::kMaxRoundMs);
  EXPECT_EQ(goals(), walked(slow_ms));
  loop(4, milliseconds{16});
  const int last_late_ms = 2 * static_cast<int>(managers::StepClock::kMaxRoundMs) + 2 * 16;
  EXPECT_EQ(goals(), walked(slow_ms + last_late_ms)) << "the time beyond the bound is lost";
}

TEST_F(SlowLoop, AControllerThatIsTooSlowGetsOneMessageWithTheStepThatFits) {
  testing::internal::CaptureStderr();
  standing().start();
  loop(400, milliseconds{24});
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr(std::string{managers::messages::kTooSlow} + "24 ms"));
  EXPECT_THAT(said, HasSubstr(std::string{managers::messages::kDeclare} + "step(24)"));
  EXPECT_EQ(lines(said), 1);
}

TEST_F(SlowLoop, NoMoreMessagesComeIfItBecomesSlower) {
  testing::internal::CaptureStderr();
  standing().start();
  loop(400, milliseconds{24});
  loop(400, milliseconds{40});
  EXPECT_EQ(lines(testing::internal::GetCapturedStderr()), 1);
}

TEST_F(SlowLoop, AStartAfterARestTakesNothingOfIt) {
  standing().start();
  loop(20, milliseconds{16});
  manager().stop();
  robot().step(500);
  manager().start();
  loop(2, milliseconds{16});
  EXPECT_EQ(goals(), walked(32));
}

TEST_F(SlowLoop, ALoopInTimeGetsNoSuchMessage) {
  for (const int step_ms : {8, 16, 20, 24, 40}) {
    manager_.reset();
    end();
    testing::internal::CaptureStderr();
    standing().start();
    steps(4000 / step_ms, step_ms);
    fake.pass(milliseconds{300});  // one late round
    steps(4000 / step_ms, step_ms);
    EXPECT_THAT(testing::internal::GetCapturedStderr(), Not(HasSubstr(managers::messages::kTooSlow))) << step_ms;
  }
}

TEST(StepClock, UnevenImagesOfALoopInTimeAddNothing) {
  managers::StepClock clock;
  double robot_ms = 0, played_ms = 0;
  for (int step = 0; step < 1000; ++step) {
    if (step % 2 == 1) robot_ms += 32;
    played_ms += clock.advance(16, robot_ms, 16);
  }
  EXPECT_NEAR(played_ms, 16'000, 32);
}

TEST(StepClock, StepsOfAFractionOfACycleAddNothing) {
  managers::StepClock clock;
  for (int step = 0; step < 1000; ++step)
    ASSERT_EQ(clock.advance(20, 16 * std::ceil(20 * step / 16.0), 16), 20) << step;
}

TEST(StepClock, ALoopThatDeclaredTooMuchIsFollowedSoonAfter) {
  managers::StepClock clock;
  double robot_ms = 0, played_ms = 0;
  for (int step = 0; step < 1000; ++step) (void)clock.advance(32, robot_ms += 16, 16);
  for (int step = 0; step < 20; ++step) played_ms += clock.advance(16, robot_ms += 48, 16);
  EXPECT_NEAR(played_ms, 20 * 48, managers::StepClock::kMaxRoundMs + 16);
}

TEST(StepClock, APauseCountsAsDeclared) {
  managers::StepClock clock;
  (void)clock.advance(16, 0, 16);
  EXPECT_EQ(clock.advance(16, managers::StepClock::kPauseMs + 16, 16), 16);
}

TEST(StepClock, OnlyALoopThatIsSlowForLongIsCalledSlow) {
  managers::StepClock clock;
  double robot_ms = 0;
  const auto rounds = [&](int count, double round_ms) {
    for (int round = 0; round < count; ++round) {
      (void)clock.advance(16, robot_ms += round_ms, 16);
      ASSERT_EQ(clock.slowRoundMs(), 0);
    }
  };
  rounds(100, 24);
  rounds(300, 16);
  for (int pause = 0; pause < 10; ++pause) {
    rounds(1, 300);
    rounds(100, 16);
  }
}

/// As in code of the robot, where a thread walked.
TEST_F(SlowLoop, WithoutStepOfTheManagerTheRobotsStepsWalk) {
  standing().start();
  for (int i = 0; i < 20; ++i) robot().step(16);
  EXPECT_EQ(goals(), walked(320));
  manager().stop();
  EXPECT_EQ(goals(), gait::kStanding.tick);
}

TEST_F(SlowLoop, AManagerThatTheControllerStepsIsLeftToIt) {
  standing().start();
  steps(10);
  const auto there = goals();
  robot().step(16);
  robot().step(16);
  EXPECT_EQ(goals(), there);
  steps(1);
  EXPECT_NE(goals(), there);
}

}  // namespace
}  // namespace darwinop::webots_api
