// Ends during a walk: the step is finished before the session ends, so that the robot kneels from both feet.
#include <gmock/gmock.h>

#include "gait_rig.hpp"

namespace darwinop::webots_api {
namespace {

using std::chrono::milliseconds;

class EndOfWalk : public GaitManager {
 protected:
  void walkInto(int step) {
    standing().setXAmplitude(1);
    manager().start();
    steps(60 + step);
    ASSERT_NE(goals(), gait::kStanding.tick);
  }
  /// A walk with this period_time, ms.
  void walkWith(int period_ms, int step) {
    stop = false;
    manager_.reset();
    end();
    fake.published.clear();
    write("[Walking Config]\nperiod_time = " + std::to_string(period_ms) + "\n");
    walkInto(step);
  }
  /// Greatest change of a goal in a step, rad, from published[first] to the last one.
  [[nodiscard]] double greatestChange(std::size_t first) const {
    double change = 0;
    for (std::size_t i = first + 1; i < fake.published.size(); ++i)
      for (std::size_t joint = 0; joint < kWalking; ++joint)
        change = std::max(change, std::abs(fake.published[i].joint[joint].goal.value -
                                           fake.published[i - 1].joint[joint].goal.value));
    return change;
  }
  static constexpr milliseconds kLongest{2900};
  static constexpr std::size_t kStand = 400 / 16;  // steps
  /// The bound of docs/gait.md: 1.5 periods and what limited goals need, then 0.4 s of standing.
  static constexpr milliseconds kBound{2 * 600 + 600 + 400};
};

TEST_F(EndOfWalk, AfterCtrlCTheLastStepReturnsInTheStance) {
  for (int moment = 0; moment < 38; moment += 3) {  // one period
    stop = false;
    manager_.reset();
    end();
    fake.end_of_session = false;
    walkInto(moment);
    const Nanos before = fake.now;
    stop = true;
    manager().step(16);
    EXPECT_EQ(robot().step(16), -1);
    EXPECT_EQ(goals(), gait::kStanding.tick) << moment;
    EXPECT_LE(fake.now - before, kBound) << moment;
    EXPECT_FALSE(fake.end_of_session);
    const std::size_t published = fake.published.size();
    manager().step(16);
    EXPECT_EQ(robot().step(16), -1) << "at once";
    EXPECT_EQ(fake.published.size(), published);
  }
}

TEST_F(EndOfWalk, CtrlCDuringAStepReturnsFromItInTheStance) {
  for (int moment = 0; moment < 38; moment += 3) {
    stop = false;
    manager_.reset();
    end();
    walkInto(moment);
    fake.during_wait = [this] { stop = true; };
    manager().step(16);
    EXPECT_EQ(robot().step(16), -1);
    EXPECT_EQ(goals(), gait::kStanding.tick) << moment;
  }
}

TEST_F(EndOfWalk, CtrlCDuringALongStepDoesNotWaitForItsEnd) {
  walkInto(7);
  const Nanos before = fake.now;
  fake.during_wait = [this] { stop = true; };
  EXPECT_EQ(robot().step(5000), -1);
  EXPECT_EQ(goals(), gait::kStanding.tick);
  EXPECT_LE(fake.now - before, kBound);
}

/// The last step swings on when the last goal is reached.
TEST_F(EndOfWalk, TheRobotStandsBeforeItKneels) {
  walkInto(7);
  stop = true;
  EXPECT_EQ(robot().step(16), -1);
  constexpr std::size_t kStood = 400 / 16;
  ASSERT_GT(fake.published.size(), kStood);
  const Commands& first = fake.published[fake.published.size() - kStood];
  for (std::size_t i = 0; i < kWalking; ++i)
    EXPECT_EQ(ticksFromRad(first.joint[i].goal), gait::kStanding.tick[i]) << kJointTable[i].name;
}

TEST_F(EndOfWalk, ALongPeriodIsNotWaitedForAndNothingMovesAfterwards) {
  write("[Walking Config]\nperiod_time = 3000\n");
  walkInto(44);  // shortly after the right foot came down: the second time from here is too late
  Nanos before = fake.now;
  stop = true;
  EXPECT_EQ(robot().step(16), -1);
  EXPECT_NE(goals(), gait::kStanding.tick);
  EXPECT_LT(fake.now - before, milliseconds{3000}) << "the supervisor kills after 3 s";
  before = fake.now;
  EXPECT_EQ(robot().step(16), -1);
  manager_.reset();
  EXPECT_EQ(fake.now, before);
}

TEST_F(EndOfWalk, EachOfTheLastStepsHasACycle) {
  for (const bool during_wait : {false, true}) {
    stop = false;
    manager_.reset();
    end();
    walkInto(7);
    std::size_t published = fake.published.size(), most = 0;
    fake.on_cycle = [&](std::uint64_t) {
      most = std::max(most, fake.published.size() - published);
      published = fake.published.size();
    };
    if (during_wait)
      fake.during_wait = [this] { stop = true; };
    else
      stop = true;
    manager().step(16);
    EXPECT_EQ(robot().step(16), -1);
    EXPECT_EQ(most, 1) << "goals of two steps in one cycle would be a jump";
    fake.on_cycle = nullptr;
  }
}

TEST_F(EndOfWalk, CtrlCWhileTheRuntimeEndsAlsoFinishesTheSteps) {
  walkInto(7);
  stop = true;
  fake.ending = true;
  EXPECT_EQ(robot().step(16), -1);
  EXPECT_EQ(goals(), gait::kStanding.tick);
}

TEST_F(EndOfWalk, AControllerThatReturnsFromMainEndsInTheStance) {
  walkInto(7);
  end();  // ~Robot, as exit() and an uncaught exception
  EXPECT_EQ(goals(), gait::kStanding.tick);
  EXPECT_TRUE(fake.end_of_session);
}

TEST_F(EndOfWalk, AManagerDestroyedBeforeItsRobotEndsInTheStance) {
  walkInto(7);
  manager_.reset();
  EXPECT_EQ(goals(), gait::kStanding.tick);
  EXPECT_EQ(robot().step(16), 0);
}

TEST_F(EndOfWalk, AtTheEndOfTheRuntimeTheLastStepReturnsInTheStance) {
  walkInto(7);
  fake.ending = true;
  testing::internal::CaptureStderr();
  EXPECT_EQ(robot().step(16), -1);
  testing::internal::GetCapturedStderr();
  EXPECT_EQ(goals(), gait::kStanding.tick);
}

TEST_F(EndOfWalk, ALoopThatHasGoneIsNotWaitedFor) {
  walkInto(7);
  fake.gone = true;
  const Nanos before = fake.now;
  const std::size_t published = fake.published.size();
  testing::internal::CaptureStderr();
  EXPECT_EQ(robot().step(16), -1);
  end();
  testing::internal::GetCapturedStderr();
  EXPECT_EQ(fake.now, before);
  EXPECT_LE(fake.published.size(), published + 2) << "by the step, and by one attempt to carry on";
}

TEST_F(EndOfWalk, APeriodOf1600MsIsFinishedWithinTheBound) {
  for (int step = 0; step < 100; step += 9) {
    walkWith(1600, step);
    const Nanos before = fake.now;
    stop = true;
    EXPECT_EQ(robot().step(16), -1);
    EXPECT_EQ(goals(), gait::kStanding.tick) << step;
    EXPECT_LE(fake.now - before, kLongest) << step;
  }
}

TEST_F(EndOfWalk, AStepThatTakesLongerStopsWhereItIs) {
  constexpr int kPeriod = 3000 / 16, kFirst = 3;  // steps
  const double kTick = radFromTicks(1).value - radFromTicks(0).value;
  walkWith(3000, 2 * kPeriod);
  const double usual = greatestChange(kFirst);
  int unfinished = 0;
  for (int step = 0; step < kPeriod; step += 17) {
    walkWith(3000, step);
    const std::size_t begun = fake.published.size();
    const Nanos before = fake.now;
    stop = true;
    EXPECT_EQ(robot().step(16), -1);
    EXPECT_LE(fake.now - before, kLongest) << step;
    ASSERT_GT(fake.published.size() - begun, kStand) << step;
    EXPECT_LE(greatestChange(begun - 1), usual + kTick) << "no jump at " << step;
    EXPECT_EQ(greatestChange(fake.published.size() - kStand), 0) << "it stands still at " << step;
    unfinished += goals() == gait::kStanding.tick ? 0 : 1;
    end();
    EXPECT_TRUE(fake.end_of_session);
  }
  EXPECT_GT(unfinished, 0);
}

TEST_F(EndOfWalk, SafetyIsNotInterfered) {
  walkInto(7);
  fake.image.safety.state = State::kKneeling;
  const Nanos before = fake.now;
  end();
  EXPECT_EQ(fake.now, before);
}

TEST_F(EndOfWalk, OnTheWayToTheStanceItEndsAtOnce) {
  manager().start();
  steps(20);
  const Nanos before = fake.now;
  stop = true;
  EXPECT_EQ(robot().step(16), -1);
  EXPECT_LE(fake.now - before, milliseconds{16}) << "both feet are down";
}

}  // namespace
}  // namespace darwinop::webots_api
