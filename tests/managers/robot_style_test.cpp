// Controllers in the style of the robot of 2013: pages and walks advance without a call of step() of the manager.
#include <gmock/gmock.h>

#include <RobotisOp2MotionManager.hpp>
#include <cstdlib>
#include <webots/Motor.hpp>

#include "motion_rig.hpp"
#include "motion_stage.hpp"

namespace darwinop::webots_api {
namespace {

using testing::ElementsAre;

/// As in published controllers: step() of the manager exists in the simulator only.
class Player2013 : public webots::Robot {
 public:
  Player2013(RobotImpl* impl, const std::string& file)
      : Robot(impl), motion_manager(new managers::RobotisOp2MotionManager(this, file)), time_step(16) {}
  ~Player2013() override { delete motion_manager; }

  /// Steps until the page has ended, at most `limit`.
  int playAsynchronously(int page, int limit) {
    motion_manager->playPage(page, false);
    int steps = 0;
    while (motion_manager->isMotionPlaying() && steps < limit) {
#ifndef CROSSCOMPILATION
      motion_manager->step(time_step);
#endif
      myStep();
      ++steps;
    }
    return steps;
  }
  void myStep() {
    if (step(time_step) == -1) std::exit(EXIT_SUCCESS);
  }
  managers::RobotisOp2MotionManager* motion_manager;
  int time_step;
};

using RobotStyle = MotionManagerTest;

TEST_F(RobotStyle, AnAsynchronousPageIsPlayedByTheStepsOfTheRobot) {
  end();
  Player2013 robot{makeImpl(), path_};
  fake.published.clear();
  EXPECT_EQ(robot.playAsynchronously(1, 100), 7);
  EXPECT_THAT(necks(), ElementsAre(2003, 2012, 2037, 2062, 2088, 2100, 2100)) << "as with step() of the manager";
  robot.getMotor("Neck")->setPosition(0.1);
  robot.myStep();
  EXPECT_EQ(last(Joint::kNeck).goal.value, 0.1) << "the page has ended";
  EXPECT_EQ(robot.playAsynchronously(2, 100), 9) << "16 ticks of 8 ms; the end shows with the tick after them";
}

/// Its image processing takes this long in each step.
class SlowRobot : public webots::Robot {
 public:
  SlowRobot(RobotImpl* impl, FakeRobot& fake) : Robot(impl), fake_{fake} {}
  int step(int ms) override {
    const int late = Robot::step(ms);
    fake_.pass(std::chrono::milliseconds{24});
    return late;
  }

 private:
  FakeRobot& fake_;
};

TEST_F(RobotStyle, APageThatIsWaitedForTakesTheRobotsTimeInASlowLoop) {
  pages_[1].step[0].time = 255;  // 2 s
  write();
  end();
  SlowRobot robot{makeImpl(), fake};
  managers::RobotisOp2MotionManager manager{&robot, path_};
  const Nanos begun = fake.now;
  manager.playPage(1);
  EXPECT_NEAR(static_cast<double>((fake.now - begun).count()) * 1e-9, 258 * 0.008, 0.15);
}

TEST_F(RobotStyle, APageOfMotionPlayTakesTheRobotsTimeInASlowLoop) {
  pages_[1].step[0].time = 255;  // 2 s
  write();
  end();
  SlowRobot robot{makeImpl(), fake};
  motion::PlayStage stage{robot};
  EXPECT_TRUE(stage.page(path_, 1));
  EXPECT_NEAR(stage.seconds(), 258 * 0.008, 0.15);
  fake.image.safety.state = State::kOffline;
  EXPECT_FALSE(stage.page(path_, 1)) << "not followed";
}

TEST_F(RobotStyle, APageTakesTheRobotsTimeInASlowLoop) {
  managers::RobotisOp2MotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  int rounds = 0;
  for (; manager.isMotionPlaying() && rounds < 100; ++rounds) {
    robot().step(16);
    fake.pass(std::chrono::milliseconds{32});  // computes until two more cycles have passed
  }
  EXPECT_EQ(rounds, 5) << "104 ms of the page, 32 ms a round from the third on";
  EXPECT_EQ(ticksOf(Joint::kNeck), 2100);
}

TEST_F(RobotStyle, ALongPauseDoesNotSkipThePage) {
  managers::RobotisOp2MotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  robot().step(16);
  fake.pass(std::chrono::seconds{10});
  robot().step(16);
  robot().step(16);
  EXPECT_TRUE(manager.isMotionPlaying());
  EXPECT_LT(ticksOf(Joint::kNeck), 2050);
}

TEST_F(RobotStyle, AManagerThatTheControllerStepsIsLeftToIt) {
  managers::RobotisOp2MotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  robot().step(16);
  manager.step(16);
  robot().step(16);
  robot().step(16);
  robot().step(16);
  EXPECT_THAT(necks(), ElementsAre(2003, 2012, 2012, 2012));
}

}  // namespace
}  // namespace darwinop::webots_api
