// The whole way of a picture: from a ball before a robot to a head that follows it.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <optional>

#include "core/faults.hpp"
#include "runtime/environment.hpp"
#include "system/rig.hpp"

namespace darwinop {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;
using testing::Not;

constexpr long kARoundOfTheBall = 700;  // cycles; 8 s are 500, and the robot takes its time to be ready

class EyesOfARobot : public Rig {
 protected:
  /// The example, for `time` of the robot's clock.
  std::string track(const std::string& robot, const std::string& time) {
    Program running{{program("darwinop-run"), "--robot", robot, DARWINOP_VISUAL_TRACKING, "--seconds", time},
                    file("run.txt")};
    EXPECT_EQ(running.wait(seconds{120}), 0) << running.output();
    return running.output();
  }
  static long linesOf(const std::string& path) {
    std::ifstream text{path};
    return std::count(std::istreambuf_iterator<char>{text}, {}, '\n');
  }
  static double rangeOf(const std::string& recording, const std::string& column) {
    const Recording log{recording};
    double low = 10, high = -10;
    for (std::size_t row = 0; row < log.rows(); ++row) {
      const double value = log.at(row, column);
      if (!std::isnan(value)) low = std::min(low, value), high = std::max(high, value);
    }
    return high - low;
  }
};

TEST_F(EyesOfARobot, FollowAMovingBallInTheTwin) {
  const runtime::Environment ball{"DARWINOP_TWIN_BALL", "circles"};
  const runtime::Environment recording{"DARWINOP_RECORD", file("log.csv")};
  EXPECT_GE(percentIn(track("twin", "10")), 95);
  EXPECT_GT(rangeOf(file("log.csv"), "Neck.position [rad]"), 0.4) << "0.15 m either side, 0.55 m ahead";
}

TEST_F(EyesOfARobot, SeeTheSameInEveryRun) {
  const runtime::Environment ball{"DARWINOP_TWIN_BALL", "circles"};
  EXPECT_EQ(track("twin", "4"), track("twin", "4"));
}

TEST_F(EyesOfARobot, SeeNoBallWhereThereIsNone) {
  const runtime::Environment ball{"DARWINOP_TWIN_BALL", "none"};
  EXPECT_EQ(percentIn(track("twin", "4")), 0);
}

TEST_F(EyesOfARobot, SeeNothingInATestPattern) {
  const runtime::Environment blind{"DARWINOP_TWIN_GL", "off"};
  const std::string said = track("twin", "4");
  EXPECT_THAT(said, HasSubstr("DARWINOP_TWIN_GL")) << "and why";
  EXPECT_EQ(percentIn(said), 0) << "its red bar is not a ball";
}

TEST_F(EyesOfARobot, AreUsedByControllersOfBothStyles) {
  const runtime::Environment ball{"DARWINOP_TWIN_BALL", "circles"};
  const runtime::Environment red{"DARWINOP_TWIN_BALL_COLOUR", "red"};  // upstream's visual tracking seeks a red one
  const runtime::Environment recording{"DARWINOP_RECORD", file("log.csv")};
  for (const char* controller : {DARWINOP_TRACKING_OF_2013, DARWINOP_TRACKING_OF_TODAY}) {
    Program running{{program("darwinop-run"), "--robot", "twin", controller}, file("run.txt")};
    for (int tries = 0; tries < 60 && linesOf(file("log.csv")) < kARoundOfTheBall; ++tries)
      EXPECT_FALSE(running.wait(seconds{1}).has_value()) << "it goes on for ever: " << running.output();
    running.kill(SIGINT);
    EXPECT_EQ(running.wait(seconds{20}), 0) << running.output();
    EXPECT_GT(rangeOf(file("log.csv"), "Neck.position [rad]"), 0.4) << controller << ": " << running.output();
    std::filesystem::remove(file("log.csv"));
  }
}

class EyesInRealTime : public EyesOfARobot {
 protected:
  /// A robot with a body on a serial line, and programs of this test see what it sees.
  void startSeeingRobot() {
    virtual_robot_ =
        std::make_unique<Program>(std::vector<std::string>{program("darwinop-virtual-robot"), "--body", "twin",
                                                           "--link", port(), "--camera", file("frames")},
                                  file("virtual-robot.txt"));
    ASSERT_TRUE(virtual_robot_->says("body:", seconds{20})) << virtual_robot_->output();
    preload_.emplace("LD_PRELOAD", DARWINOP_VIRTUAL_CAMERA_LIBRARY);
    file_.emplace("DARWINOP_VIRTUAL_CAMERA", file("frames"));
  }

  std::optional<runtime::Environment> preload_, file_;
};

// Counted from the first sight: the first picture of a software renderer takes seconds on a busy machine.
TEST_F(EyesInRealTime, FollowTheBallOfARobotOnASerialLine) {
  constexpr const char* kSight = "I see";
  startSeeingRobot();
  EXPECT_THAT(virtual_robot_->output(), HasSubstr("export LD_PRELOAD="));
  Program running{{program("darwinop-run"), "--robot", port(), DARWINOP_VISUAL_TRACKING}, file("run.txt")};
  ASSERT_TRUE(running.says(kSight, seconds{30})) << running.output();
  const std::size_t before = running.output().find(kSight);
  const auto lines_since = [&] { return std::ranges::count(running.output().substr(before), '\n'); };
  for (int tries = 0; tries < 15 && lines_since() < 4; ++tries)  // the example prints a line a second
    EXPECT_FALSE(running.wait(seconds{1}).has_value()) << "it ended: " << running.output();
  const std::string since = running.output().substr(before);
  EXPECT_GE(lines_since(), 4) << since;
  EXPECT_THAT(since, Not(HasSubstr("No ball"))) << "it lost the ball";
  running.kill(SIGINT);
  EXPECT_EQ(running.wait(seconds{20}), 0) << running.output();
  EXPECT_GT(percentIn(running.output()), 0) << running.output();
}

class WithATroubledCamera : public EyesInRealTime, public testing::WithParamInterface<const char*> {};

INSTANTIATE_TEST_SUITE_P(Faults, WithATroubledCamera, testing::Values("gone", "silent"));

TEST_P(WithATroubledCamera, LoopAndControllerGoOn) {
  startVirtualRobot();
  Program running{{program("darwinop-virtual-camera"), "--fault", GetParam(), "--fault-at", "4", "--fault-for", "3",
                   "--", program("darwinop-run"), "--robot", port(), DARWINOP_VISUAL_TRACKING, "--seconds", "8"},
                  file("run.txt")};
  EXPECT_EQ(running.wait(seconds{60}), 0) << running.output();
  const std::string said = running.output();
  EXPECT_THAT(said, HasSubstr("/dev/video0"));
  EXPECT_THAT(said, HasSubstr("back"));
  EXPECT_GT(percentIn(said), 20);
  EXPECT_LT(percentIn(said), 90);
  const auto report = reportLine(said);
  EXPECT_GE(report.at("cycles"), 500) << "8 s of 16 ms: " << said;
  EXPECT_LT(report.at("overruns"), 50) << said;
  EXPECT_THAT(said, Not(HasSubstr(std::string{row(Fault::kControllerStalled).name}))) << "half a second without a step";
}

}  // namespace
}  // namespace darwinop
