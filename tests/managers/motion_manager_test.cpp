// The motion manager as controllers use it: synchronous and asynchronous pages, goals, gains, and what is refused.
#include <gmock/gmock.h>

#include <DARwInOPMotionManager.hpp>
#include <DARwInOPMotionTimerManager.hpp>
#include <RobotisOp2MotionManager.hpp>
#include <RobotisOp2MotionTimerManager.hpp>
#include <fstream>
#include <utility>
#include <webots/Motor.hpp>

#include "motion/pages.hpp"
#include "support/temporary_folder.hpp"
#include "webots/fixture.hpp"
#include "webots/lead_in.hpp"

namespace darwinop::facade {
namespace {

using managers::DARwInOPMotionManager;
using managers::RobotisOp2MotionManager;
using motion::pageOf;
using motion::stepTo;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

class MotionManagerTest : public Facade {
 protected:
  MotionManagerTest() {
    for (JointSensors& joint : fake.image.joint) joint.position = joint.commanded = radFromTicks(2000);
    pages_[1] = pageOf({stepTo(2100, 10)});  // 13 ticks
    pages_[2] = pageOf({stepTo(2100, 13)});  // 16 ticks
    pages_[2].slopes[3] = 0x77;
    write();
    robot();
    fake.published.clear();
  }
  void write() {
    const auto bytes = motion::encodePages(pages_);
    std::ofstream{path_, std::ios::binary}.write(reinterpret_cast<const char*>(bytes.data()),
                                                 static_cast<std::streamsize>(bytes.size()));
  }
  const JointCommand& last(Joint joint) { return fake.last().joint[index(joint)]; }
  /// The neck's goals in ticks in every image that was published.
  std::vector<int> necks() {
    std::vector<int> seen;
    for (const Commands& image : fake.published) {
      const JointCommand& neck = image.joint[index(Joint::kNeck)];
      seen.push_back(neck.has(JointCommand::kGoal) ? ticksFromRad(neck.goal) : -1);
    }
    return seen;
  }
  int ticksOf(Joint joint) { return ticksFromRad(last(joint).goal); }

  TemporaryFolder folder_;
  std::string path_ = folder_ / "pages.bin";
  motion::PageFile pages_ = motion::emptyFile();
};

TEST_F(MotionManagerTest, ASynchronousPageStepsTheRobotUntilItHasEnded) {
  DARwInOPMotionManager manager{&robot(), path_};
  EXPECT_TRUE(manager.isCorrectlyInitialized());
  manager.playPage(1);
  EXPECT_FALSE(manager.isMotionPlaying());
  // Two ticks a step: 0 3 | 12 12 | 24 37 | 50 62 | 75 88 | 88 100 | 100.
  EXPECT_THAT(necks(), ElementsAre(2003, 2012, 2037, 2062, 2088, 2100, 2100));
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_EQ(ticksOf(static_cast<Joint>(i)), 2100);
  EXPECT_NEAR(robot().getMotor("Head")->getTargetPosition(), radFromTicks(2100).value, 1e-12);
}

TEST_F(MotionManagerTest, WholeStepsAreAllThatAPageTakes) {
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(2);
  EXPECT_EQ(fake.published.size(), 8u) << "16 ticks of 8 ms";
}

TEST_F(MotionManagerTest, ASynchronousPageEndsWithTheController) {
  DARwInOPMotionManager manager{&robot(), path_};
  fake.on_cycle = [this](std::uint64_t) { stop = fake.published.size() == 3; };
  manager.playPage(1);
  EXPECT_FALSE(manager.isMotionPlaying());
  EXPECT_THAT(necks(), ElementsAre(2003, 2012, 2037, 2062)) << "the step that gave -1 had been published";
  EXPECT_EQ(ticksFromRad(Rad{robot().getMotor("Neck")->getTargetPosition()}), 2062) << "and no further";
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
  EXPECT_EQ(last(Joint::kNeck).goal.value, 0.1) << "over: the joints are the controller's";
}

TEST_F(MotionManagerTest, WhatIsLeftOfAStepIsCarriedOver) {
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  for (const int ms : {7, 0, -20, 1, 20, 20}) {
    manager.step(ms);
    robot().step(16);
  }
  // Ticks by then: 0 0 0 1 3 6.
  EXPECT_THAT(necks(), ElementsAre(-1, -1, -1, 2000, 2012, 2037));
}

TEST_F(MotionManagerTest, ABasicTimeStepOfItsOwnKeepsTheRate) {
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

TEST_F(MotionManagerTest, AnotherPageWhileOneIsPlayedIsRefusedAndSaid) {
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  CaptureStderr();
  manager.playPage(2);
  manager.playPage(2, false);
  EXPECT_EQ(GetCapturedStderr(), "darwinop: MotionManager: page 2 is refused: page 1 is still being played\n");
  EXPECT_TRUE(fake.published.empty());
  manager.step(16);
  robot().step(16);
  EXPECT_EQ(ticksOf(Joint::kNeck), 2003) << "the first one goes on";
}

TEST_F(MotionManagerTest, APageThatIsNotThereIsSaid) {
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

TEST_F(MotionManagerTest, ABadFileIsSaidOnceAndNothingPlays) {
  std::fstream{path_, std::ios::in | std::ios::out | std::ios::binary}.seekp(5 * 512 + 70).put('\x11');
  CaptureStderr();
  DARwInOPMotionManager manager{&robot(), path_};
  RobotisOp2MotionManager twin{&robot(), path_};
  EXPECT_THAT(GetCapturedStderr(),
              testing::MatchesRegex("darwinop: MotionManager: [^\n]*: page 5, byte 2591: the checksum is wrong: "
                                    "[^\n]*; no page will be played\n"));
  EXPECT_FALSE(manager.isCorrectlyInitialized() || twin.isCorrectlyInitialized());
  CaptureStderr();
  manager.playPage(1);
  manager.playPage(1, false);
  manager.step(16);
  EXPECT_EQ(GetCapturedStderr(), "darwinop: MotionManager: page 1 is skipped: there is no motion file\n");
  EXPECT_FALSE(manager.isMotionPlaying());
  EXPECT_TRUE(fake.published.empty());
}

/// With a data directory of its own.
struct Elsewhere : DARwInOPMotionManager {
  Elsewhere(webots::Robot* robot, const std::string& file, const std::string& directory)
      : DARwInOPMotionManager(robot, file, directory) {}
};

TEST_F(MotionManagerTest, WithoutACustomFileItIsTheOneInTheDataDirectory) {
  std::filesystem::copy(path_, folder_ / "motion_4096.bin");
  CaptureStderr();
  EXPECT_TRUE((Elsewhere{&robot(), path_, "/nowhere/"}.isCorrectlyInitialized()));
  Elsewhere manager{&robot(), "", folder_ / ""};
  EXPECT_TRUE(manager.isCorrectlyInitialized());
  EXPECT_EQ(GetCapturedStderr(), "");
  manager.playPage(2);
  EXPECT_EQ(fake.published.size(), 8u) << "16 ticks of 8 ms";
}

TEST_F(MotionManagerTest, WithoutAnyFileItPlaysOwnPagesAndSaysSoOnce) {
  CaptureStderr();
  Elsewhere missing{&robot(), "", folder_ / ""}, again{&robot(), "", folder_ / ""};
  EXPECT_EQ(GetCapturedStderr(), "darwinop: MotionManager: there is no " + (folder_ / "motion_4096.bin") +
                                     ": the runtime's own pages are played (darwinop motion list own)\n");
  EXPECT_TRUE(missing.isCorrectlyInitialized());
  missing.playPage(9, false);
  EXPECT_TRUE(missing.isMotionPlaying());
  missing.step(1000);
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_NE(ticksOf(Joint::kLegLowerR), 2000) << "it stands up";
}

TEST_F(MotionManagerTest, OwnPagesCanBeAskedForByName) {
  std::filesystem::copy(path_, folder_ / "motion_4096.bin");
  CaptureStderr();
  Elsewhere manager{&robot(), "own", folder_ / ""};
  manager.playPage(9, false);
  EXPECT_TRUE(manager.isMotionPlaying()) << "the file in the directory has no page 9";
  EXPECT_EQ(GetCapturedStderr(), "");
}

TEST_F(MotionManagerTest, OwnPagesNeverReplaceAFile) {
  CaptureStderr();
  DARwInOPMotionManager missing{&robot(), folder_ / "none.bin"};
  EXPECT_FALSE(missing.isCorrectlyInitialized());
  EXPECT_EQ(GetCapturedStderr(),
            "darwinop: MotionManager: " + (folder_ / "none.bin") + ": it cannot be opened; no page will be played\n");
  std::ofstream{folder_ / "motion_4096.bin"} << "darwinop motion 1\n[page 1]\nNeck = x\n";
  CaptureStderr();
  Elsewhere broken{&robot(), "", folder_ / ""};
  EXPECT_FALSE(broken.isCorrectlyInitialized());
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("motion_4096.bin, line 3, page 1: Neck, step 1: 'x' is not an angle"));
  std::filesystem::remove(folder_ / "motion_4096.bin");
  std::filesystem::create_symlink("/nowhere/at/all", folder_ / "motion_4096.bin");
  forgetWarnings();
  CaptureStderr();
  EXPECT_FALSE((Elsewhere{&robot(), "", folder_ / ""}.isCorrectlyInitialized())) << "a link to a disk that is away";
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("it cannot be opened; no page will be played"));
}

TEST_F(MotionManagerTest, ACustomFileMayBeText) {
  std::ofstream{folder_ / "mine.txt"} << "darwinop motion 1\n[page 3]\ntime = 1\nNeck = 4\n";
  DARwInOPMotionManager manager{&robot(), folder_ / "mine.txt"};
  EXPECT_TRUE(manager.isCorrectlyInitialized());
  manager.playPage(3);
  EXPECT_EQ(ticksOf(Joint::kNeck), 2048 + 46) << "4 degrees";
}

/// As a robot does it: what was asked for is where the joints are in the next cycle.
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
  /// rad in a step of 16 ms, of all joints, that were at 2000 ticks before.
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

TEST_F(GentleStart, APageThatIsFarAwayIsNotJumpedTo) {
  pages_[1].step[0].position.fill(2048 + 400);
  pages_[1].step[0].position[19] = motion::kKeep;
  write();
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  manager.step(16);
  robot().step(16);
  for (const int ticks : necks()) EXPECT_EQ(ticks, 2000) << "it has no part in the first step";
  EXPECT_NEAR(ticksOf(Joint::kHead), 2000, 2) << "and the others begin where they are";
  int steps = 1;
  for (; manager.isMotionPlaying() && steps < 1000; ++steps) {
    manager.step(16);
    robot().step(16);
  }
  EXPECT_LE(fastest(), LeadIn::kSpeed * 0.016 + 1e-9);
  EXPECT_EQ(ticksOf(Joint::kHead), 2448);
  EXPECT_NEAR(steps * 0.016, 1.5 * 448 * kRadPerTick / LeadIn::kSpeed + 13 * 0.008, 0.032) << "the page comes behind";
  fake.published.clear();
  manager.playPage(1);
  EXPECT_EQ(fake.published.size(), 7u) << "13 ticks: nothing is added when the robot is there";
}

TEST_F(GentleStart, AFirstStepThatServosCanDoIsAsItWas) {
  // 187 ticks in 80 ms are 3.59 rad/s; with twice the time it is less than half of what a servo does without a load.
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

TEST_F(GentleStart, APageBySpeedIsJudgedByItsSpeed) {
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
  EXPECT_LE(fastest(), LeadIn::kSpeed * 0.016 + 1e-9);
}

TEST_F(GentleStart, WhoeverTakesTheJointsEndsIt) {
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

TEST_F(MotionManagerTest, WithoutARobotItSaysSo) {
  CaptureStderr();
  DARwInOPMotionManager manager{nullptr, path_};
  manager.playPage(1);
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("MotionManager: it was given no robot; no page will be played\n"));
  EXPECT_FALSE(manager.isCorrectlyInitialized());
}

TEST_F(MotionManagerTest, ThePagesGainsLastAsLongAsThePage) {
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
  EXPECT_EQ(last(Joint::kArmUpperR).p_gain, 5) << "that of a joint which was given none";
  EXPECT_EQ(last(Joint::kHead).p_gain, 6) << "the controller's own";
  EXPECT_TRUE(last(Joint::kArmUpperR).has(JointCommand::kPGain));
  EXPECT_EQ(GetCapturedStderr(), "") << "a weak gain is the page's wish, not the user's mistake";
}

TEST_F(MotionManagerTest, GoneInTheMiddleOfAPageItGivesTheGainsBack) {
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

TEST_F(MotionManagerTest, APageBeginsWhereTheRobotHasItsGoals) {
  auto& joint = fake.image.joint;
  joint[0].commanded = radFromTicks(1900);         // sags by 100 ticks, and is not let down by them
  joint[1].commanded = Rad{};                      // limp: where it is
  joint[2].commanded = joint[2].position = Rad{};  // and not even known
  joint[3].position = Rad{};                       // silent, but commanded
  joint[4].commanded = radFromTicks(3000);         // still far on its way: where it is, and as far as it pulls
  robot().getMotor("ArmUpperR")->setPosition(radFromTicks(2222).value);
  robot().getMotor("Neck")->setPosition(0.7);  // never sent: the robot knows nothing of it
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

TEST_F(MotionManagerTest, NothingKnownAndVelocityControlIsTheMiddle) {
  fake.image.joint[2].commanded = fake.image.joint[2].position = Rad{};
  robot().getMotor("ArmUpperR")->setPosition(INFINITY);
  robot().step(16);
  DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  manager.step(8);
  robot().step(16);
  EXPECT_EQ(ticksOf(Joint::kArmUpperR), 2048);
}

TEST_F(MotionManagerTest, ACopyPlaysOnItsOwn) {
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

TEST_F(MotionManagerTest, AStepFromInsideOfAStepPlaysNothingTwice) {
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
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("page 1 is skipped: there is no robot\n"));
}

TEST_F(MotionManagerTest, TheTimerNeedsNoStartAndSaysNothing) {
  CaptureStderr();
  managers::DARwInOPMotionTimerManager::MotionTimerInit();
  managers::RobotisOp2MotionTimerManager::MotionTimerInit();
  EXPECT_EQ(GetCapturedStderr(), "");
}

}  // namespace
}  // namespace darwinop::facade
