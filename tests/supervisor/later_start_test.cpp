// A default controller that was stopped, or whose supervisor died: what starts it again.
#include <gmock/gmock.h>

#include "runtime/marker_file.hpp"
#include "safety/fault_book.hpp"
#include "supervisor/home.hpp"
#include "supervisor/messages.hpp"

namespace darwinop::supervisor {
namespace {

using testing::HasSubstr;

TEST_F(Home, AfterAKilledSupervisorTheNextStartsNoController) {
  startVirtualRobot();
  plan("hold");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  supervisor_->kill(SIGKILL);
  EXPECT_TRUE(within(seconds{20}, [&] { return runtime::FileLock::holder(runtime::RuntimeFiles{}.loop_lock) == 0; }));
  startSupervisor();  // as systemd does after 5 s
  ASSERT_TRUE(says(messages::kAfterKill)) << supervisor_->output();
  ASSERT_TRUE(says(messages::kRuntimeReady)) << supervisor_->output();
  EXPECT_FALSE(within(seconds{6}, [&] { return status().controller_pid != 0; })) << supervisor_->output();
  EXPECT_EQ(ask("--restart-controller"), 0) << said_;
  EXPECT_TRUE(within(seconds{20}, [&] { return status().controller_pid != 0; })) << supervisor_->output();
}

TEST_F(Home, AControllerThatWasStoppedStaysSoWithTheNextSupervisor) {
  startVirtualRobot();
  plan("sit");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  EXPECT_EQ(ask("--stop"), 0) << said_;
  supervisor_->wait(seconds{5});
  startSupervisor();  // it ran before, so it runs again
  ASSERT_TRUE(within(seconds{20}, [&] { return status().controller_pid != 0; })) << supervisor_->output();
  EXPECT_EQ(ask("--stop-controller"), 0) << said_;
  EXPECT_EQ(ask("--stop"), 0) << said_;
  supervisor_->wait(seconds{5});
  startSupervisor();  // as in an upgrade
  ASSERT_TRUE(says(messages::kStaysEnded)) << supervisor_->output();
  ASSERT_TRUE(says(messages::kRuntimeReady)) << supervisor_->output();
  EXPECT_FALSE(within(seconds{6}, [&] { return status().controller_pid != 0; })) << supervisor_->output();
}

/// A person released the robot, restarted its supervisor while the board was off, and gives the command before it is
/// on.
TEST_F(Home, ARestartBeforeTheRobotIsSwitchedOnResetsARecordedRelease) {
  runtime::MarkerFile{runtime::RuntimeFiles{}.released}.set(true);
  plan("hold");
  startSupervisor();
  ASSERT_TRUE(within(seconds{10}, [&] { return status().runtime_pid != 0; })) << supervisor_->output();
  EXPECT_EQ(ask("--restart-controller"), 0) << said_;
  startVirtualRobot();
  EXPECT_TRUE(controllerSays("stands")) << supervisor_->output();
}

TEST_F(Home, AStopOfTheControllerLeavesARecordedReleaseForTheNextRestart) {
  runtime::MarkerFile{runtime::RuntimeFiles{}.released}.set(true);
  plan("hold");
  startSupervisor();
  ASSERT_TRUE(within(seconds{10}, [&] { return status().runtime_pid != 0; })) << supervisor_->output();
  EXPECT_EQ(ask("--restart-controller"), 0) << said_;
  EXPECT_EQ(ask("--stop-controller"), 0) << said_;
  startVirtualRobot();
  ASSERT_TRUE(says(messages::kRuntimeReady)) << supervisor_->output();
  std::this_thread::sleep_for(seconds{1});
  EXPECT_TRUE(sensors().safety.active[safety::rowIndex(Fault::kReleasedByOperator)]);
}

TEST_F(Home, ARestartFailsWhileTheSupervisorStops) {
  startVirtualRobot();
  plan("unresponsive");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  supervisor_->kill(SIGTERM);
  ASSERT_TRUE(within(seconds{3}, [&] { return status().stopping; }));
  EXPECT_EQ(ask("--restart-controller"), 1);
  EXPECT_THAT(said_, HasSubstr(messages::kEndedBefore));
}

/// The cable is out: a restart waits for the rescue, and the stop that follows ends this too.
TEST_F(Home, AStopOfTheControllerCancelsARestartThatWaitsForARescue) {
  startVirtualRobot("12 unplug for 12\n");  // it stands after 3 s, or later on a busy machine
  plan("hold");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands", seconds{12})) << supervisor_->output() << controllerLog();
  ASSERT_TRUE(staysOffline());
  kill(status().runtime_pid, SIGKILL);
  ASSERT_TRUE(says(messages::kCannotReachRobot, seconds{10})) << supervisor_->output();
  EXPECT_EQ(ask("--restart-controller"), 0) << said_;
  EXPECT_EQ(ask("--stop-controller"), 0) << said_;
  ASSERT_TRUE(says(messages::kRescued, seconds{40})) << supervisor_->output();
  EXPECT_FALSE(within(seconds{5}, [&] { return status().runtime_pid != 0 || status().controller_pid != 0; }))
      << supervisor_->output();
  EXPECT_EQ(registers().stiff, 0);
}

}  // namespace
}  // namespace darwinop::supervisor
