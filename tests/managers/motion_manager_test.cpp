// Motion manager: synchronous and asynchronous pages, goals, gains, refusals.
#include <gmock/gmock.h>

#include <DARwInOPMotionManager.hpp>
#include <DARwInOPMotionTimerManager.hpp>
#include <RobotisOp2MotionManager.hpp>
#include <RobotisOp2MotionTimerManager.hpp>
#include <fstream>
#include <webots/Motor.hpp>

#include "managers/messages.hpp"
#include "motion_rig.hpp"

namespace darwinop::webots_api {
namespace {

using managers::DARwInOPMotionManager;
using managers::RobotisOp2MotionManager;
using motion::pageOf;
using motion::stepTo;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

TEST_F(MotionManagerTest, ASynchronousPageStepsTheRobotUntilItEnds) {
  DARwInOPMotionManager manager{&robot(), path_};
  EXPECT_TRUE(manager.isCorrectlyInitialized());
  manager.playPage(1);
  EXPECT_FALSE(manager.isMotionPlaying());
  // Two ticks per step: 0 3 | 12 12 | 24 37 | 50 62 | 75 88 | 88 100 | 100.
  EXPECT_THAT(necks(), ElementsAre(2003, 2012, 2037, 2062, 2088, 2100, 2100));
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_EQ(ticksOf(static_cast<Joint>(i)), 2100);
  EXPECT_NEAR(robot().getMotor("Head")->getTargetPosition(), radFromTicks(2100).value, 1e-12);
}

TEST_F(MotionManagerTest, APageTakesWholeSteps) {
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(2);
  EXPECT_EQ(fake.published.size(), 8u) << "16 ticks of 8 ms";
}

TEST_F(MotionManagerTest, ASynchronousPageEndsWithTheController) {
  DARwInOPMotionManager manager{&robot(), path_};
  fake.on_cycle = [this](std::uint64_t) { stop = fake.published.size() == 3; };
  manager.playPage(1);
  EXPECT_FALSE(manager.isMotionPlaying());
  EXPECT_THAT(necks(), ElementsAre(2003, 2012, 2037, 2062)) << "the step that returned -1 was published";
  EXPECT_EQ(ticksFromRad(Rad{robot().getMotor("Neck")->getTargetPosition()}), 2062) << "no later goals";
  EXPECT_EQ(robot().step(16), -1);
}

TEST_F(MotionManagerTest, AnAsynchronousPageIsPlayedByStep) {
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  EXPECT_TRUE(manager.isMotionPlaying());
  EXPECT_TRUE(fake.published.empty());
  int steps = 0;
  for (; manager.isMotionPlaying() && steps < 100; ++steps) {
    manager.step(16);
    robot().step(16);
  }
  EXPECT_THAT(necks(), ElementsAre(2003, 2012, 2037, 2062, 2088, 2100, 2100));
  manager.step(16);
  EXPECT_FALSE(manager.isMotionPlaying());
  robot().getMotor("Neck")->setPosition(0.1);
  manager.step(16);
  robot().step(16);
  EXPECT_EQ(last(Joint::kNeck).goal.value, 0.1) << "the page has ended: the controller's goals apply";
}

TEST_F(MotionManagerTest, TheRemainderOfAStepIsCarriedOver) {
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  for (const int ms : {7, 0, -20, 1, 20, 20}) {
    manager.step(ms);
    robot().step(16);
  }
  // Ticks: 0 0 0 1 3 6.
  EXPECT_THAT(necks(), ElementsAre(-1, -1, -1, 2000, 2012, 2037));
}

TEST_F(MotionManagerTest, AnotherBasicTimeStepKeepsTheRate) {
  // 13 ticks are 104 ms. In steps shorter than a tick the end shows with the tick after it.
  const std::pair<int, std::size_t> kSteps[] = {{4, 27}, {8, 13}, {20, 6}, {100, 2}};
  for (const auto& [step_ms, steps] : kSteps) {
    config.time_step_ms = step_ms;
    end();
    DARwInOPMotionManager manager{&robot(), path_};
    fake.published.clear();
    manager.playPage(1);
    EXPECT_EQ(ticksOf(Joint::kNeck), 2100) << step_ms;
    EXPECT_EQ(fake.published.size(), steps) << step_ms;
  }
}

TEST_F(MotionManagerTest, ASecondPageIsRefusedWithAMessage) {
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  CaptureStderr();
  manager.playPage(2);
  manager.playPage(2, false);
  EXPECT_EQ(GetCapturedStderr(), "darwinop: MotionManager: page 2 is refused: page 1 is still being played\n");
  EXPECT_TRUE(fake.published.empty());
  manager.step(16);
  robot().step(16);
  EXPECT_EQ(ticksOf(Joint::kNeck), 2003) << "the first one continues";
}

TEST_F(MotionManagerTest, AMissingPageIsReported) {
  DARwInOPMotionManager manager{&robot(), path_};
  CaptureStderr();
  for (const int page : {-1, 0, 256, 77}) manager.playPage(page);
  const std::string said = GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("page -1 does not exist: pages are 1 to 255\n"));
  EXPECT_THAT(said, HasSubstr("page 256 does not exist"));
  EXPECT_THAT(said, HasSubstr("page 77 is empty: nothing is played\n"));
  EXPECT_FALSE(manager.isMotionPlaying());
  EXPECT_TRUE(fake.published.empty());
}

TEST_F(MotionManagerTest, ADamagedPageIsRefusedAndTheOthersPlay) {
  std::fstream{path_, std::ios::in | std::ios::out | std::ios::binary}.seekp(2 * 512 + 70).put('\x11');
  CaptureStderr();
  DARwInOPMotionManager manager{&robot(), path_};
  const std::string said = GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr(path_ + ": page 2, byte 1055: "));
  EXPECT_THAT(said, HasSubstr(managers::messages::kPageIsRefused));
  ASSERT_TRUE(manager.isCorrectlyInitialized());
  CaptureStderr();
  manager.playPage(2);
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("page 2 is empty"));
  EXPECT_TRUE(fake.published.empty());
  manager.playPage(1);
  EXPECT_EQ(ticksOf(Joint::kNeck), 2100);
}

TEST_F(MotionManagerTest, AnInvalidFileIsReportedOnceAndNothingPlays) {
  std::ofstream{path_, std::ios::binary | std::ios::trunc} << std::string(1030, '\0');
  CaptureStderr();
  DARwInOPMotionManager manager{&robot(), path_};
  RobotisOp2MotionManager twin{&robot(), path_};
  EXPECT_THAT(GetCapturedStderr(), testing::MatchesRegex("darwinop: MotionManager: [^\n]*page 2, at byte 1030; "
                                                         "[^\n]*; no page will be played\n"));
  EXPECT_FALSE(manager.isCorrectlyInitialized() || twin.isCorrectlyInitialized());
  CaptureStderr();
  manager.playPage(1);
  manager.playPage(1, false);
  manager.step(16);
  EXPECT_EQ(GetCapturedStderr(), "darwinop: MotionManager: page 1 is skipped: no motion file\n");
  EXPECT_FALSE(manager.isMotionPlaying());
  EXPECT_TRUE(fake.published.empty());
}

TEST_F(MotionManagerTest, ANullRobotIsReported) {
  CaptureStderr();
  DARwInOPMotionManager manager{nullptr, path_};
  manager.playPage(1);
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("MotionManager: the robot is null; no page will be played\n"));
  EXPECT_FALSE(manager.isCorrectlyInitialized());
}

TEST_F(MotionManagerTest, ThePagesGainsEndWithThePage) {
  config.safety.default_p_gain = 5;
  end();
  robot().getMotor("Head")->setControlPID(6, 0, 0);
  CaptureStderr();
  DARwInOPMotionManager manager{&robot(), path_};
  fake.published.clear();
  manager.playPage(2);
  for (const Commands& image : fake.published) {
    EXPECT_EQ(image.joint[index(Joint::kArmUpperR)].p_gain, 1) << "slope 0x77 is register 8";
    EXPECT_EQ(image.joint[index(Joint::kHead)].p_gain, 4);
  }
  robot().step(16);
  EXPECT_EQ(last(Joint::kArmUpperR).p_gain, 5) << "default gain";
  EXPECT_EQ(last(Joint::kHead).p_gain, 6) << "the controller's gain";
  EXPECT_TRUE(last(Joint::kArmUpperR).has(JointCommand::kPGain));
  EXPECT_EQ(GetCapturedStderr(), "") << "a low gain of a page is not an error";
}

TEST_F(MotionManagerTest, RestoresTheGainsIfDestroyedDuringAPage) {
  {
    DARwInOPMotionManager manager{&robot(), path_};
    manager.playPage(2, false);
    manager.step(16);
    robot().step(16);
    EXPECT_EQ(last(Joint::kArmUpperR).p_gain, 1);
  }
  robot().step(16);
  EXPECT_EQ(last(Joint::kArmUpperR).p_gain, 4);
}

TEST_F(MotionManagerTest, APageStartsAtTheRobotsGoals) {
  auto& joint = fake.image.joint;
  joint[0].commanded = radFromTicks(1900);         // sags by 100 ticks: starts at its goal
  joint[1].commanded = Rad{};                      // limp: starts at its position
  joint[2].commanded = joint[2].position = Rad{};  // unknown
  joint[3].position = Rad{};                       // unknown position, but commanded
  joint[4].commanded = radFromTicks(3000);         // far from its goal: starts near its position
  robot().getMotor("ArmUpperR")->setPosition(radFromTicks(2222).value);
  robot().getMotor("Neck")->setPosition(0.7);  // never sent
  robot().step(16);
  joint[2].commanded = joint[2].position = Rad{};
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  manager.step(8);
  robot().step(16);
  EXPECT_EQ(ticksOf(Joint::kShoulderR), 1900);
  EXPECT_EQ(ticksOf(Joint::kShoulderL), 2000);
  EXPECT_EQ(ticksOf(Joint::kArmUpperR), 2222);
  EXPECT_EQ(ticksOf(Joint::kArmUpperL), 2000);
  EXPECT_EQ(ticksOf(Joint::kArmLowerR), 2256);
  EXPECT_EQ(ticksOf(Joint::kNeck), 2000);
}

TEST_F(MotionManagerTest, UnknownJointsInVelocityControlStartAtTheStartPose) {
  fake.image.joint[2].commanded = fake.image.joint[2].position = Rad{};
  robot().getMotor("ArmUpperR")->setPosition(INFINITY);
  robot().step(16);
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  manager.step(8);
  robot().step(16);
  EXPECT_EQ(ticksOf(Joint::kArmUpperR), row(Joint::kArmUpperR).start);
}

TEST_F(MotionManagerTest, ACopyPlaysIndependently) {
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  DARwInOPMotionManager copy{manager}, assigned{&robot(), path_};
  assigned = manager;
  DARwInOPMotionManager& itself = manager;
  manager = itself;
  EXPECT_TRUE(manager.isMotionPlaying());
  EXPECT_FALSE(copy.isMotionPlaying() || assigned.isMotionPlaying());
  EXPECT_TRUE(copy.isCorrectlyInitialized() && assigned.isCorrectlyInitialized());
  copy.playPage(2, false);
  copy.step(16);
  EXPECT_TRUE(copy.isMotionPlaying());
}

TEST_F(MotionManagerTest, ANestedStepHasNoEffect) {
  DARwInOPMotionManager manager{&robot(), path_};
  const auto cycles_of = [&](int page) {
    const std::size_t before = fake.published.size();
    manager.playPage(page);
    return fake.published.size() - before;
  };
  const std::size_t alone = cycles_of(1);
  fake.on_cycle = [&](std::uint64_t) { manager.step(16); };
  EXPECT_EQ(cycles_of(1), alone);
}

TEST_F(MotionManagerTest, MayOutliveItsRobot) {
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  manager.step(16);
  end();
  manager.step(16);
  EXPECT_FALSE(manager.isMotionPlaying());
  CaptureStderr();
  manager.playPage(1);
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("page 1 is skipped: no robot\n"));
}

TEST_F(MotionManagerTest, TheTimerManagerDoesNothing) {
  CaptureStderr();
  managers::DARwInOPMotionTimerManager::MotionTimerInit();
  managers::RobotisOp2MotionTimerManager::MotionTimerInit();
  EXPECT_EQ(GetCapturedStderr(), "");
}

}  // namespace
}  // namespace darwinop::webots_api
