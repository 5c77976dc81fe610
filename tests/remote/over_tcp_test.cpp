// The example controllers over TCP behave as on a local robot.
#include <gmock/gmock.h>

#include <cstdlib>
#include <thread>

#include "remote/client/messages.hpp"
#include "remote/server/messages.hpp"
#include "runtime/environment.hpp"
#include "system/rig.hpp"

namespace darwinop {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;
using testing::Not;

class OverTcp : public Rig {
 protected:
  /// Starts `darwinop remote`; returns the robot setting for a controller.
  std::string serve(const std::string& robot, const std::vector<std::string>& options = {}) {
    std::vector<std::string> command{program("darwinop-remote"), "--robot", robot, "--port", port_};
    command.insert(command.end(), options.begin(), options.end());
    server_ = std::make_unique<Program>(command, file("remote.txt"));
    port_ = server_->restOfLine("ready: 127.0.0.1:", seconds{20});
    EXPECT_FALSE(port_.empty()) << server_->output();
    return "tcp://127.0.0.1:" + port_;
  }
  /// Output of a controller that ends normally.
  std::string runOn(const std::string& robot, const std::vector<std::string>& command) {
    const runtime::Environment setting{"DARWINOP_ROBOT", robot};
    Program running{command, file("run.txt")};
    EXPECT_EQ(running.wait(seconds{90}), 0) << running.output();
    return running.output();
  }

  std::string port_ = "0";
  std::unique_ptr<Program> server_;
};

TEST_F(OverTcp, ExamplesPrintTheSameAsOnALocalVirtualRobot) {
  const std::string robot = serve("virtual");
  for (const std::vector<std::string>& example : {std::vector<std::string>{DARWINOP_HELLO_HEAD, "--seconds", "5"},
                                                  {DARWINOP_SYMMETRY, "--seconds", "3"},
                                                  {DARWINOP_LEDS, "--seconds", "3"},
                                                  {DARWINOP_WALK, "--seconds", "4", "--x", "1"}})
    EXPECT_EQ(runOn(robot, example), runOn("virtual", example)) << example[0];
  EXPECT_THAT(server_->output(), HasSubstr(remote::messages::kSessionEnded));
  EXPECT_THAT(server_->output(), Not(HasSubstr(remote::messages::kNeverAnswered)));
}

#ifdef DARWINOP_WITH_TWIN
TEST_F(OverTcp, TheTwinWalks) {
  const std::string robot = serve("twin");
  const std::vector<std::string> walk{DARWINOP_WALK, "--seconds", "5", "--x", "1"};
  EXPECT_EQ(runOn(robot, walk), runOn("twin", walk)) << "which fails if the robot falls";
}

TEST_F(OverTcp, TheHeadFollowsABallThroughTheNetwork) {
  const runtime::Environment ball{"DARWINOP_TWIN_BALL", "circles"};
  const std::string said = runOn(serve("twin"), {DARWINOP_VISUAL_TRACKING, "--seconds", "8"});
  EXPECT_GE(percentIn(said), 90) << said;
}
#endif

TEST_F(OverTcp, ReconnectsInRealTimeToAServerThatWasKilledAndRestarted) {
  startVirtualRobot();
  Program daemon{{program("darwinop-runtime"), "--robot", Rig::port()}, file("daemon.txt")};
  ASSERT_TRUE(daemon.says("ready:", seconds{20})) << daemon.output();
  const std::string robot = serve("runtime");
  const runtime::Environment setting{"DARWINOP_ROBOT", robot};
  Program running{{DARWINOP_HELLO_HEAD, "--seconds", "6"}, file("run.txt")};
  ASSERT_TRUE(running.says("neck", seconds{30})) << running.output();
  std::this_thread::sleep_for(seconds{1});  // waits for no line: a late step skips some
  server_->kill(SIGKILL);
  ASSERT_TRUE(running.says(remote::messages::kConnectionLost, seconds{10})) << running.output();
  ASSERT_TRUE(running.says("+nan rad", seconds{10})) << "values are absent, not old: " << running.output();
  (void)serve("runtime");
  EXPECT_EQ(running.wait(seconds{30}), 0) << running.output();
  EXPECT_THAT(running.output(), HasSubstr(remote::messages::kConnectedAgain));
  const std::string last = running.output().substr(running.output().rfind("neck"));
  EXPECT_THAT(last, Not(HasSubstr("nan"))) << running.output();
  daemon.kill(SIGTERM);
  EXPECT_EQ(daemon.wait(seconds{20}), 0) << daemon.output();
}

TEST_F(OverTcp, ASecondClientWaitsUntilTheFirstHasEnded) {
  const std::string robot = serve("virtual");
  const runtime::Environment setting{"DARWINOP_ROBOT", robot};
  Program first{{DARWINOP_HELLO_HEAD}, file("first.txt")};
  ASSERT_TRUE(first.says("neck", seconds{20})) << first.output();
  Program second{{DARWINOP_HELLO_HEAD, "--seconds", "2"}, file("second.txt")};
  EXPECT_TRUE(second.says("waiting for tcp://", seconds{20})) << second.output();
  first.kill(SIGINT);
  EXPECT_EQ(first.wait(seconds{20}), 0) << first.output();
  EXPECT_EQ(second.wait(seconds{30}), 0) << second.output();
  EXPECT_THAT(second.output(), HasSubstr("neck"));
}

}  // namespace
}  // namespace darwinop
