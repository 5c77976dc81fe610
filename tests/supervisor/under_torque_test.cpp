// A servo that keeps its torque, or a board that is silent at the end: runtime, supervisor and --stop report it.
#include <gmock/gmock.h>

#include <csignal>
#include <cstring>

#include "runtime/daemon.hpp"
#include "runtime/messages.hpp"
#include "supervisor/home.hpp"
#include "supervisor/messages.hpp"
#include "support/text_of.hpp"

namespace darwinop::supervisor {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string underTorque(const std::string& joints) {
  return runtime::messages::kUnderTorque + joints + "\n";
}

class UnderTorque : public Home {
 protected:
  void startUnderASupervisor(const std::string& faults, const std::vector<std::string>& options = {}) {
    startVirtualRobot(faults, options);
    plan("hold");
    startSupervisor();
    ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  }
  /// The order, and each later one, fails with the names.
  void expectStopFailsFor(const std::string& joints) {
    EXPECT_EQ(ask("--stop"), 1);
    EXPECT_THAT(said_, HasSubstr(underTorque(joints)));
    EXPECT_EQ(supervisor_->wait(seconds{5}), runtime::kExitUnderTorque);
    EXPECT_THAT(supervisor_->output(), HasSubstr(messages::kEnded + ("; " + underTorque(joints))));
    EXPECT_EQ(ask("--stop"), 1) << "an installer that tries again";
    EXPECT_THAT(said_, HasSubstr(underTorque(joints)));
  }
  /// Runs a daemon with a controller until `end`, then ends it.
  void expectDaemonFailsFor(const std::string& joints, bool (*end)()) {
    std::ofstream{file("plan")} << "hold\n";
    std::filesystem::create_symlink(controller(), folder_ / "walk");
    Program daemon{{program("darwinop-runtime"), "--robot", port()}, file("daemon.txt")};
    ASSERT_TRUE(daemon.says("ready:", seconds{15})) << daemon.output();
    setenv("DARWINOP_ROBOT", "runtime", 1);
    Program driver{{file("walk")}, file("driver.txt")};
    unsetenv("DARWINOP_ROBOT");
    ASSERT_TRUE(driver.says("stands", seconds{20})) << driver.output();
    ASSERT_TRUE(end());
    daemon.kill(SIGTERM);
    EXPECT_EQ(daemon.wait(seconds{40}), runtime::kExitUnderTorque);
    EXPECT_THAT(daemon.output(), HasSubstr(underTorque(joints)));
  }
};

TEST_F(UnderTorque, AServoThatIgnoresTorqueOffIsNamedByStopAndSupervisor) {
  startUnderASupervisor("", {"--servo", "Neck=keeps-torque"});
  expectStopFailsFor("Neck");
  EXPECT_EQ(registers().stiff, 1);
  EXPECT_THAT(supervisor_->output(), Not(HasSubstr(messages::kRescues))) << "the runtime did all that can be done";
}

TEST_F(UnderTorque, AServoThatIgnoresTorqueOffIsNamedByTheRuntime) {
  startVirtualRobot("", {"--servo", "Neck=keeps-torque", "--servo", "LegLowerR=keeps-torque"});
  expectDaemonFailsFor("LegLowerR, Neck", [] { return true; });
}

TEST_F(UnderTorque, ABoardThatIsSilentAtTheEndLeavesAllJointsUnknown) {
  startUnderASupervisor("12 unplug for 600\n");
  ASSERT_TRUE(staysOffline());
  expectStopFailsFor(runtime::messages::kAllJoints);
}

TEST_F(UnderTorque, ABoardThatStallsIsReportedByTheRuntime) {
  startVirtualRobot("12 stall for 600\n");
  expectDaemonFailsFor(runtime::messages::kAllJoints, staysOffline);
}

TEST_F(UnderTorque, ARobotThatWasLimpBeforeItsBoardBecameSilentIsAtRest) {
  startVirtualRobot("9 unplug for 600\n");
  startSupervisor();  // without a default controller
  ASSERT_TRUE(within(seconds{15}, [] { return sensors().safety.state == State::kLimp; })) << supervisor_->output();
  ASSERT_TRUE(staysOffline());
  EXPECT_EQ(ask("--stop"), 0) << said_;
  EXPECT_EQ(supervisor_->wait(seconds{5}), 0) << supervisor_->output();
}

TEST_F(UnderTorque, AfterARescueToo) {
  startUnderASupervisor("", {"--servo", "Neck=keeps-torque"});
  kill(status().runtime_pid, SIGKILL);
  ASSERT_TRUE(says(runtime::messages::kUnderTorque + std::string{"Neck"}, seconds{60})) << supervisor_->output();
  expectStopFailsFor("Neck");
}

TEST(ExitStatus, UnderTorqueIsTheOnlyOneAfterWhichSystemdDoesNotStartTheSupervisorAgain) {
  EXPECT_THAT(textOf(DARWINOP_UNIT),
              HasSubstr("\nRestartPreventExitStatus=" + std::to_string(runtime::kExitUnderTorque) + "\n"));
  const std::string no_folder = "/no/such/folder";
  Program failing{{DARWINOP_BIN "/darwinop-supervisor", "--home", no_folder}, "/dev/null"};
  EXPECT_EQ(failing.wait(seconds{10}), 1);
}

TEST_F(UnderTorque, AServoThatFellSilentUnderTorqueIsNamed) {
  startUnderASupervisor("12 dead Neck\n");
  ASSERT_TRUE(within(seconds{30}, [] { return sensors().joint[index(Joint::kNeck)].motion.age > 200; }));
  expectStopFailsFor("Neck");
}

TEST_F(UnderTorque, ASupervisorThatIsKilledDuringAStopMakesItFail) {
  startUnderASupervisor("");
  Program asking{{program("darwinop-supervisor"), "--stop"}, file("ask.txt")};
  ASSERT_TRUE(within(seconds{10}, [this] { return status().controller_ended; }));
  supervisor_->kill(SIGKILL);
  EXPECT_EQ(asking.wait(seconds{20}), 1);
  EXPECT_THAT(asking.output(), HasSubstr(messages::kNoRecordOfRest));
  EXPECT_TRUE(within(seconds{20}, [] { return runtime::FileLock::holder(runtime::RuntimeFiles{}.loop_lock) == 0; }));
  EXPECT_EQ(registers().stiff, 0);
}

TEST_F(UnderTorque, AStopFailsIfTheSupervisorCannotRecordThatTheRobotIsAtRest) {
  // Long enough that the record's temporary file has no valid name, and the shared files of the runtime have.
  const std::string name = file(std::string(255 - std::strlen(".commands.XXXXXX"), 'x'));
  setenv("DARWINOP_RUNTIME_NAME", name.c_str(), 1);
  const std::string record = SupervisorFiles{runtime::RuntimeFiles{}}.status;
  ASSERT_FALSE(writeStatus(Status{}, record));
  Status earlier;
  earlier.at_rest = true;
  ASSERT_TRUE(writeStatus(earlier, file("earlier")));
  std::filesystem::rename(file("earlier"), record);
  startVirtualRobot();
  startSupervisor();  // without a default controller
  ASSERT_TRUE(says(messages::kRuntimeReady)) << supervisor_->output();
  for (const char* when : {"while it runs", "an installer that tries again"}) {
    EXPECT_EQ(ask("--stop"), 1) << when;
    EXPECT_THAT(said_, HasSubstr(messages::kNoRecordOfRest + name)) << when;
  }
  EXPECT_EQ(supervisor_->wait(seconds{5}), 0) << "its log says that the robot is at rest";
}

}  // namespace
}  // namespace darwinop::supervisor
