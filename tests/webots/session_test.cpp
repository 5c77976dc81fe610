// Pacing of step(), its return values, and how a session begins and ends. Time is simulated.
#include "webots/session.hpp"

#include <gmock/gmock.h>

#include <webots/Motor.hpp>

#include "fixture.hpp"
#include "webots/messages.hpp"

namespace darwinop::webots_api {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

class SessionTest : public Facade {};

TEST_F(SessionTest, AStepTakesExactlyItsTimeHoweverLongTheControllerComputes) {
  robot();
  const Nanos start = fake.now;
  for (int i = 1; i <= 100; ++i) {
    fake.pass(milliseconds{i % 11});
    EXPECT_EQ(robot().step(16), 0);
    EXPECT_EQ(fake.now - start, i * milliseconds{16});
  }
}

TEST_F(SessionTest, AStepOfTwoPeriodsSkipsACycle) {
  fake.period = milliseconds{8};
  robot();
  const Nanos start = fake.now;
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_EQ(fake.now - start, milliseconds{16});
}

TEST_F(SessionTest, StepsThatAreNotAMultipleOfThePeriodKeepTheirMeanRate) {
  robot();
  const Nanos start = fake.now;
  for (int i = 0; i < 160; ++i) EXPECT_EQ(robot().step(20), 0);
  EXPECT_EQ(fake.now - start, milliseconds{3200});
}

TEST_F(SessionTest, StepsShorterThanThePeriodAreNotLate) {
  robot();
  for (int i = 0; i < 100; ++i) {
    fake.pass(milliseconds{3});
    EXPECT_EQ(robot().step(8), 0) << i;
  }
}

TEST_F(SessionTest, ALateStepReturnsTheExcessAtOnce) {
  robot();
  fake.pass(milliseconds{21});
  const Nanos called = fake.now;
  EXPECT_EQ(robot().step(16), 5);
  EXPECT_EQ(fake.now, called);
}

TEST_F(SessionTest, AStepLateByCyclesReturnsAllOfIt) {
  robot();
  fake.pass(milliseconds{16 + 50});
  EXPECT_EQ(robot().step(16), 50);
}

TEST_F(SessionTest, AControllerThatIsAlwaysTooSlowGetsTheSameExcessEveryTime) {
  robot();
  const Nanos start = fake.now;
  for (int i = 0; i < 100; ++i) {
    fake.pass(milliseconds{20});
    EXPECT_EQ(robot().step(16), 4) << i;
  }
  EXPECT_EQ(fake.now - start, milliseconds{2000}) << "and it is not slowed down further";
}

TEST_F(SessionTest, AfterALateStepTheNextOneIsInTimeAgain) {
  robot();
  fake.pass(milliseconds{1000});
  EXPECT_GT(robot().step(16), 900);
  const Nanos late = fake.now;
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_LE(fake.now - late, milliseconds{16});
  EXPECT_GT(fake.now, late);
}

TEST_F(SessionTest, ALateStepStillPublishesAndReadsTheNewestImage) {
  robot();
  const std::size_t before = fake.published.size();
  fake.pass(milliseconds{100});
  fake.image.board.voltage = Volt{9};
  EXPECT_GT(robot().step(16), 0);
  EXPECT_EQ(fake.published.size(), before + 1);
  EXPECT_EQ(robot().batterySensorGetValue(), 9);
}

TEST_F(SessionTest, AnImageThatIsWaitedForTooLongIsALateStep) {
  robot();
  bool stalls = true;  // the first wait of the step, as behind a slow network
  fake.on_cycle = [&](std::uint64_t) {
    if (std::exchange(stalls, false)) fake.pass(milliseconds{48});
  };
  EXPECT_EQ(robot().step(16), 48);
  const Nanos late = fake.now;
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_EQ(fake.now - late, milliseconds{16}) << "and the next one is a whole one";
}

TEST_F(SessionTest, TimeNeverRunsBackwards) {
  robot();
  double before = robot().getTime();
  for (int i = 0; i < 50; ++i) {
    fake.bus_time = milliseconds{i % 5 == 0 ? 10 : 4};  // a lost reply
    fake.pass(milliseconds{18});
    const double computed = robot().getTime();
    EXPECT_GE(computed, before);
    EXPECT_EQ(robot().step(16) >= 0, true);
    before = robot().getTime();
    EXPECT_GE(before, computed) << i;
  }
}

TEST_F(SessionTest, TimeDoesNotRunBackwardsInTheLastStepsEither) {
  robot();
  EXPECT_EQ(robot().step(16), 0);
  fake.pass(milliseconds{40});
  const double before = robot().getTime();
  fake.bus_time = milliseconds{15};  // lost replies
  EXPECT_TRUE(currentRobot()->carryOn(8));
  EXPECT_GE(robot().getTime(), before);
}

TEST_F(SessionTest, TheTwoHalvesOfAStepLetTheControllerComputeMeanwhile) {
  robot();
  const Nanos start = fake.now;
  const std::size_t before = fake.published.size();
  EXPECT_EQ(robot().stepBegin(16), 0);
  EXPECT_EQ(fake.published.size(), before + 1);
  EXPECT_EQ(fake.now, start);
  fake.pass(milliseconds{9});
  EXPECT_EQ(robot().stepEnd(), 0);
  EXPECT_EQ(fake.now - start, milliseconds{16});
}

TEST_F(SessionTest, TimeCountsFromTheMomentTheRobotStoodReady) {
  robot();
  EXPECT_EQ(robot().getTime(), 0);
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_DOUBLE_EQ(robot().getTime(), 0.016);
  fake.pass(milliseconds{5});
  EXPECT_DOUBLE_EQ(robot().getTime(), 0.021);
}

TEST_F(SessionTest, StepsAddUpExactlyHoweverLongTheBusTook) {
  for (const bool real_time : {true, false}) {
    FakeRobot other;
    other.real_time = real_time;
    other.on_cycle = [&](std::uint64_t cycle) { other.now += std::chrono::microseconds{cycle % 7 * 700}; };
    RobotImpl impl{std::make_unique<FakeLink>(other), config, stop};
    ASSERT_EQ(impl.begin(), "");
    for (int n = 1; n <= 100; ++n) {
      impl.stepBegin(16);
      ASSERT_EQ(impl.stepEnd(), 0);
      EXPECT_EQ(impl.session().time(), n * milliseconds{16});
    }
  }
}

TEST_F(SessionTest, TimeIsRoundedToMilliseconds) {
  robot();
  fake.pass(std::chrono::microseconds{2600});
  EXPECT_DOUBLE_EQ(robot().getTime(), 0.003);
}

TEST_F(SessionTest, InLockstepTimeStandsStillBetweenSteps) {
  fake.real_time = false;
  robot();
  EXPECT_EQ(robot().step(16), 0);
  fake.pass(milliseconds{9});
  EXPECT_DOUBLE_EQ(robot().getTime(), 0.016);
}

TEST_F(SessionTest, TimeDoesNotGoBackOnALateStep) {
  robot();
  EXPECT_EQ(robot().step(16), 0);
  fake.pass(milliseconds{21});
  EXPECT_DOUBLE_EQ(robot().getTime(), 0.037);
  EXPECT_GT(robot().step(16), 0);
  EXPECT_DOUBLE_EQ(robot().getTime(), 0.037);
}

TEST_F(SessionTest, AControllerInALongStepIsNotTakenForAStalledOne) {
  robot().getMotor("Neck")->setPosition(0.25);
  EXPECT_EQ(robot().step(16), 0);
  std::size_t published = fake.published.size();
  Nanos received = fake.now, longest{0};
  fake.on_cycle = [&](std::uint64_t) {
    if (fake.published.size() > published) received = fake.now;
    published = fake.published.size();
    longest = std::max(longest, fake.now - received);
    EXPECT_DOUBLE_EQ(fake.last().joint[index(Joint::kNeck)].goal.value, 0.25);
  };
  EXPECT_EQ(robot().step(2000), 0);
  EXPECT_LT(longest, milliseconds{400}) << "safety holds the robot of a controller that is silent for 500 ms";
}

TEST_F(SessionTest, ALongStepEndsAtOnceWhenTheUserAsks) {
  robot();
  const Nanos start = fake.now;
  fake.on_cycle = [&](std::uint64_t) { stop = fake.now - start > milliseconds{500}; };
  EXPECT_EQ(robot().step(10000), -1);
  EXPECT_LT(fake.now - start, milliseconds{1000});
}

TEST_F(SessionTest, GettersKeepTheirImageBetweenSteps) {
  robot();
  fake.image.board.voltage = Volt{9};
  fake.pass(milliseconds{50});
  EXPECT_DOUBLE_EQ(robot().batterySensorGetValue(), 11.8);
}

TEST_F(SessionTest, TheFirstImageIsThereBeforeTheFirstStep) {
  EXPECT_DOUBLE_EQ(robot().batterySensorGetValue(), 11.8);
}

TEST_F(SessionTest, BeginWaitsForTheStartMove) {
  fake.image.safety.state = State::kStarting;
  fake.on_cycle = [&](std::uint64_t cycle) {
    if (cycle == 200) fake.image.safety.state = State::kDriven;
  };
  robot();
  EXPECT_EQ(why_not, "");
  EXPECT_EQ(fake.finished(), 200u);
  EXPECT_GE(fake.published.size(), 200u) << "a controller that waits must not look stalled";
}

TEST_F(SessionTest, BeginNamesTheJointsThatDidNotReachTheStartPoseAndDrives) {
  fake.image.safety.state = State::kDriven;
  fake.image.safety.missed_start.set(index(Joint::kLegLowerL)).set(index(Joint::kHead));
  CaptureStderr();
  robot();
  const std::string said = GetCapturedStderr();
  EXPECT_EQ(why_not, "");
  EXPECT_THAT(said, HasSubstr("not in the start pose after the slow move to it: LegLowerL, Head; look for"));
}

TEST_F(SessionTest, BeginDoesNotTrustAnImageFromBeforeItsOwnCommands) {
  fake.pass(milliseconds{1000});
  fake.image.safety.controller_must_end = true;  // left behind by the controller before
  fake.image.safety.worst = Fault::kReleasedByButton;
  const std::uint64_t before = fake.finished();
  fake.on_cycle = [&](std::uint64_t cycle) {
    if (cycle == before + 2) fake.image.safety.controller_must_end = false;
  };
  robot();
  EXPECT_EQ(why_not, "");
}

TEST_F(SessionTest, BeginSaysWhichFaultForbidsToStart) {
  fake.image.safety.controller_must_end = true;
  fake.image.safety.worst = Fault::kBatteryEmpty;
  robot();
  EXPECT_THAT(why_not, HasSubstr(std::string{row(Fault::kBatteryEmpty).meaning}));
  EXPECT_THAT(why_not, HasSubstr(std::string{row(Fault::kBatteryEmpty).remedy}));
}

TEST_F(SessionTest, BeginGivesUpOnARobotThatStaysSilentAndSaysSoMeanwhile) {
  fake.image.safety.state = State::kOffline;
  fake.image.safety.worst = Fault::kBusSilent;
  CaptureStderr();
  robot();
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("waiting: the robot is offline"));
  EXPECT_THAT(why_not, HasSubstr(std::string{row(Fault::kBusSilent).remedy}));
  EXPECT_GT(fake.now, std::chrono::seconds{30});
  EXPECT_LT(fake.now, std::chrono::seconds{31});
}

TEST_F(SessionTest, BeginIsPatientWithASlowStartMove) {
  fake.image.safety.state = State::kStarting;
  fake.on_cycle = [&](std::uint64_t) {
    if (fake.now > std::chrono::seconds{120}) fake.image.safety.state = State::kDriven;
  };
  robot();
  EXPECT_EQ(why_not, "");
}

TEST_F(SessionTest, BeginEndsWhenTheUserAsks) {
  stop = true;
  robot();
  EXPECT_EQ(why_not, messages::kAskedToEnd);
}

TEST_F(SessionTest, StopMakesStepReturnMinusOneForEver) {
  robot();
  stop = true;
  EXPECT_EQ(robot().step(16), -1);
  EXPECT_EQ(robot().step(16), -1);
  const std::size_t before = fake.published.size();
  EXPECT_EQ(robot().step(16), -1);
  EXPECT_EQ(fake.published.size(), before) << "nothing is asked of the robot any more";
}

TEST_F(SessionTest, ALateStepEndsOnStopToo) {
  robot();
  fake.pass(milliseconds{1000});
  stop = true;
  EXPECT_EQ(robot().step(16), -1);
}

TEST_F(SessionTest, AFaultThatEndsControllersIsExplainedOnce) {
  robot();
  fake.image.safety.controller_must_end = true;
  fake.image.safety.worst = Fault::kServoOverload;
  fake.image.safety.worst_joint = 14;
  CaptureStderr();
  EXPECT_EQ(robot().step(16), -1);
  EXPECT_EQ(robot().step(16), -1);
  const FaultRow& fault = row(Fault::kServoOverload);
  EXPECT_EQ(GetCapturedStderr(),
            "darwinop: " + std::string{fault.meaning} + " (LegLowerL, id 14); " + std::string{fault.remedy} + "\n");
}

TEST_F(SessionTest, ALinkThatEndsIsExplainedOnce) {
  robot();
  fake.gone = true;
  CaptureStderr();
  EXPECT_EQ(robot().step(16), -1);
  EXPECT_EQ(robot().step(16), -1);
  EXPECT_EQ(GetCapturedStderr(), "darwinop: the daemon has gone\n");
}

TEST_F(SessionTest, OtherFaultsDoNotEndTheController) {
  robot();
  fake.image.safety.worst = Fault::kBatteryLow;
  fake.image.safety.active.set(3);
  EXPECT_EQ(robot().step(16), 0);
}

TEST_F(SessionTest, StartInPlaceIsAskedForInEveryImage) {
  config.safety.start = safety::StartMove::kHold;
  robot();
  EXPECT_TRUE(fake.published.front().start_where_it_is);
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_TRUE(fake.last().start_where_it_is);
}

}  // namespace
}  // namespace darwinop::webots_api
