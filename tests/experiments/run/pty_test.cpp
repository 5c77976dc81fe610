// darwinop experiment with a virtual robot on a pty, in real time: --yes, and Ctrl-C during a run.
#include <gmock/gmock.h>
#include <signal.h>

#include <cerrno>
#include <cstring>

#include "experiment_run.hpp"
#include "experiments/run/recorded.hpp"
#include "experiments/run/runner.hpp"
#include "system/rig.hpp"

namespace darwinop {
namespace {

using testing::HasSubstr;
using testing::Not;

class OnPty : public Rig {
 protected:
  std::vector<std::string> command(const std::string& name) {
    return {program("darwinop-experiment"), "run", name, "--robot", port(), "--record", file("log.csv")};
  }
};

TEST_F(OnPty, CtrlCReturnsTheRobotToItsStartPoseAndKeepsTheRecording) {
  startVirtualRobot();
  Program run{command("speed"), file("run.txt")};
  ASSERT_TRUE(run.says("rad/s, left", std::chrono::seconds{20})) << run.output();
  run.kill(SIGINT);
  EXPECT_TRUE(run.says(experiments::kReturnPhase, std::chrono::seconds{5})) << run.output();
  EXPECT_EQ(run.wait(std::chrono::seconds{30}), 130) << run.output();
  const std::string log = [this] {
    std::ostringstream text;
    text << std::ifstream{file("log.csv")}.rdbuf();
    return text.str();
  }();
  EXPECT_THAT(log, HasSubstr("# experiment: speed"));
  EXPECT_TRUE(log.ends_with("# end\n"));
}

TEST_F(OnPty, ASecondCtrlCEndsTheReturnAsStopped) {
  startVirtualRobot();
  Program run{command("speed"), file("run.txt")};
  ASSERT_TRUE(run.says("rad/s, left", std::chrono::seconds{20})) << run.output();
  run.kill(SIGINT);
  ASSERT_TRUE(run.says(experiments::kReturnPhase, std::chrono::seconds{5})) << run.output();
  run.kill(SIGINT);
  EXPECT_EQ(run.wait(std::chrono::seconds{30}), 130) << run.output();
  EXPECT_THAT(run.output(), HasSubstr(std::string{experiments::kStoppedOnRequest} + experiments::kRecordedUntilThen));
}

// Its size limit stands for a full disk. The shared memory of the loop is a file also, which has to fit.
TEST_F(OnPty, AStoppedRunWhoseRecordingIsIncompleteSaysNothingElseAboutIt) {
  startVirtualRobot();
  std::vector<std::string> limited{"/bin/bash", "-c", "trap '' XFSZ; ulimit -f 1024; exec \"$0\" \"$@\""};
  const std::vector<std::string> speed = command("speed");
  limited.insert(limited.end(), speed.begin(), speed.end());
  Program run{limited, file("run.txt")};
  ASSERT_TRUE(run.says(std::strerror(EFBIG), std::chrono::seconds{60})) << run.output();
  run.kill(SIGINT);
  EXPECT_EQ(run.wait(std::chrono::seconds{30}), 130) << run.output();
  EXPECT_THAT(run.output(), HasSubstr(experiments::kRecordedInPart));
  EXPECT_THAT(run.output(), HasSubstr(experiments::kStoppedOnRequest));
  EXPECT_THAT(run.output(), Not(HasSubstr(experiments::kRecordedUntilThen)));
}

// The same robot behind another path is not provably virtual.
TEST_F(OnPty, PortThatMayBeARobotReceivesNothingWithoutYes) {
  std::filesystem::copy_file(program("darwinop-virtual-robot"), file("robot"));
  Program robot{{file("robot"), "--link", port()}, file("robot.txt")};
  ASSERT_TRUE(robot.says("link:", std::chrono::seconds{10})) << robot.output();
  Program run{command("speed"), file("run.txt")};
  EXPECT_EQ(run.wait(std::chrono::seconds{20}), 3);
  EXPECT_THAT(run.output(), HasSubstr("moves    Neck      -1.571 to 1.571 rad, at most 12.2 rad/s"));
  EXPECT_THAT(run.output(), HasSubstr("--yes"));
  EXPECT_FALSE(std::filesystem::exists(file("log.csv")));
  robot.kill(SIGTERM);
  EXPECT_EQ(robot.wait(std::chrono::seconds{10}), 0);
  EXPECT_THAT(robot.output(), HasSubstr("frames: 0 ")) << "nothing was written";
}

}  // namespace
}  // namespace darwinop
