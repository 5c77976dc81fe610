// System test of supervisor, runtime and default controller, and of the robot's state after failures.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdint>

#include "safety/fault_book.hpp"
#include "safety/start_pose.hpp"
#include "supervisor/home.hpp"
#include "supervisor/messages.hpp"

namespace darwinop::supervisor {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double kGentle = 2.0;     // rad/s, [Safety] gentle_speed of home.hpp; the default is 1.194
constexpr double kStretched = 0.9;  // rad from the start pose, at least, when the test controller stands
constexpr std::size_t kKnee = index(Joint::kLegLowerR);

/// Message of the default controller while this fault lasts.
std::string waitingFor(Fault fault) {
  return messages::kWaitingForUser + std::string{row(fault).meaning};
}

/// Reads every image until no process publishes any more.
struct Course {
  double fastest = 0;  // rad/s of the knee's goal between images
  bool crouched = false, red = false, offline = false;

  void update(const Sensors& seen) {
    if (seen.cycle == before.cycle) return;
    const bool next = seen.cycle > before.cycle;
    const double step = seen.joint[kKnee].commanded.value - before.joint[kKnee].commanded.value;
    const double time = static_cast<double>(seen.time_ns - before.time_ns) * 1e-9;
    if (next && std::isfinite(step)) fastest = std::max(fastest, std::abs(step) / time);
    crouched = crouched || seen.safety.state == State::kKneeling;
    red = red || (seen.board.led_panel == 1 && seen.board.led_head == 0x1F);
    before = seen;
  }
  Sensors before;
};

class RuntimeFails : public Home, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(By, RuntimeFails,
                         testing::Values(SIGKILL, SIGSTOP, SIGILL, SIGTRAP, SIGABRT, SIGBUS, SIGFPE, SIGSEGV, SIGSYS),
                         [](const auto& by) { return std::string{"SIG"} + sigabbrev_np(by.param); });

TEST_P(RuntimeFails, TheRobotCrouchesSlowlyToTheStartPoseAndGoesLimp) {
  startVirtualRobot();
  plan("hold");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  const Sensors standing = sensors();
  ASSERT_GT(std::abs(standing.joint[kKnee].position.value - radFromTicks(row(Joint::kLegLowerR).start).value),
            kStretched);
  const pid_t failed = status().runtime_pid;
  kill(failed, GetParam());

  Course course;
  ASSERT_TRUE(within(seconds{40},
                     [&] {  // a stall of 80 ms silences the board, and the crouch restarts
                       const Sensors seen = sensors();
                       if (seen.cycle != 0 && kill(failed, 0) != 0) course.update(seen);
                       return supervisor_->output().find(messages::kRescued) != std::string::npos;
                     }))
      << supervisor_->output();
  EXPECT_TRUE(course.crouched);
  EXPECT_TRUE(course.red);
  EXPECT_GT(course.fastest, 0.9 * kGentle);  // with the settings of robot.ini, not the defaults
  EXPECT_LE(course.fastest, 1.01 * kGentle);

  const Registers robot = registers();  // the port is free again
  EXPECT_EQ(robot.silent, 0);
  EXPECT_EQ(robot.stiff, 0);
  EXPECT_LT(robot.furthest, 0.1);
  EXPECT_EQ(robot.panel, 1);
  EXPECT_EQ(robot.head, 0x1F);

  if (GetParam() == SIGSTOP) return;
  std::this_thread::sleep_for(milliseconds{2500});  // longer than the pause before a restart
  EXPECT_EQ(status().runtime_pid, 0);
  EXPECT_EQ(status().controller_pid, 0);
  EXPECT_EQ(ask("--status"), 0);
  EXPECT_THAT(said_, HasSubstr(messages::kRescued));
}

TEST_F(Home, WithServosAloneARuntimeDeathIsRescuedToo) {
  std::ofstream{folder_ / "home/robot.ini"} << "[Robot]\nport = " << port()
                                            << "\nboard = none\ncontroller_user = root\n[Safety]\ngentle_speed = 2.0\n";
  startVirtualRobot("", {"--board", "none"});
  plan("hold");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  ASSERT_GT(std::abs(sensors().joint[kKnee].position.value - radFromTicks(row(Joint::kLegLowerR).start).value),
            kStretched);
  const pid_t failed = status().runtime_pid;
  kill(failed, SIGKILL);

  Course course;
  ASSERT_TRUE(within(seconds{40}, [&] {
    const Sensors seen = sensors();
    if (seen.cycle != 0 && kill(failed, 0) != 0) course.update(seen);
    return supervisor_->output().find(messages::kRescued) != std::string::npos;
  })) << supervisor_->output();
  EXPECT_TRUE(course.crouched);
  EXPECT_LE(course.fastest, 1.01 * kGentle);
  const Registers robot = registers();
  EXPECT_EQ(robot.panel, -1) << "no board answers";
  EXPECT_EQ(robot.silent, 0);
  EXPECT_EQ(robot.stiff, 0);
  EXPECT_LT(robot.furthest, 0.1);
}

TEST_F(Home, ALimpRobotWhoseRuntimeDiesStaysLimp) {
  startVirtualRobot();
  startSupervisor();  // without a default controller
  ASSERT_TRUE(says(messages::kRuntimeReady)) << supervisor_->output();
  const pid_t failed = status().runtime_pid;
  kill(failed, SIGKILL);
  bool driven = false;
  int rescue_images = 0;
  ASSERT_TRUE(within(seconds{12}, [&] {
    const Sensors seen = sensors();
    rescue_images += seen.cycle != 0 && kill(failed, 0) != 0 ? 1 : 0;
    for (const JointSensors& joint : seen.joint) driven = driven || joint.driven || joint.torque_enabled;
    return supervisor_->output().find(messages::kRescued) != std::string::npos;
  })) << supervisor_->output();
  EXPECT_FALSE(driven);
  EXPECT_GT(rescue_images, 0);
  EXPECT_EQ(registers().stiff, 0);

  plan("once");
  EXPECT_EQ(ask("--restart-controller"), 0) << said_;
  EXPECT_TRUE(says(std::string{"walk"} + messages::kEndedByItself)) << supervisor_->output();
  EXPECT_NE(status().runtime_pid, 0);
  EXPECT_EQ(ask("--stop"), 0) << said_;
}

TEST_F(Home, ARuntimeDeathDuringUnplugIsRescuedAfterReplug) {
  startVirtualRobot("8 unplug for 4\n");  // it stands after 3 s, or later on a busy machine
  plan("hold");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands", seconds{8})) << supervisor_->output() << controllerLog();
  ASSERT_TRUE(staysOffline());
  kill(status().runtime_pid, SIGKILL);
  ASSERT_TRUE(says(messages::kCannotReachRobot, seconds{10})) << supervisor_->output();
  ASSERT_TRUE(says(messages::kRescued)) << supervisor_->output();
  const std::string output = supervisor_->output();
  EXPECT_EQ(output.find(messages::kCannotReachRobot), output.rfind(messages::kCannotReachRobot));
  const Registers robot = registers();
  EXPECT_EQ(robot.stiff, 0);
  EXPECT_LT(robot.furthest, 0.1);
}

/// As Python's multiprocessing does: the lease belongs to both.
TEST_F(Home, WhatACrashedControllerHasForkedDoesNotKeepTheRobot) {
  startVirtualRobot();
  plan("fork");
  startSupervisor();
  EXPECT_TRUE(says(std::string{"walk"} + messages::kFailed + "3 ", seconds{25})) << supervisor_->output();
}

TEST_F(Home, AfterThreeCrashesTheRobotIsHeldWithRedLights) {
  startVirtualRobot();
  plan("crash");
  startSupervisor();
  ASSERT_TRUE(says(std::string{"walk"} + messages::kFailed + "3 ", seconds{25})) << supervisor_->output();
  ASSERT_TRUE(within(seconds{3}, [&] { return sensors().board.led_head == 0x1F; }));
  std::this_thread::sleep_for(milliseconds{300});  // the failure happened during a movement
  const Sensors held = sensors();
  std::this_thread::sleep_for(milliseconds{2500});
  const Sensors later = sensors();
  EXPECT_EQ(later.safety.state, State::kDriven);
  EXPECT_EQ(later.board.led_panel, 1);
  EXPECT_EQ(later.board.led_head, 0x1F);
  for (std::size_t i = 0; i < kJoints; ++i) {
    EXPECT_TRUE(later.joint[i].torque_enabled) << i;
    EXPECT_NEAR(later.joint[i].position.value, held.joint[i].position.value, 0.02) << i;
  }
  EXPECT_EQ(status().controller_pid, 0);
  EXPECT_EQ(status().crashes, 3U);
  EXPECT_EQ(ask("--status"), 0);
  EXPECT_THAT(said_, AllOf(HasSubstr(messages::kFailed), HasSubstr(describe(process::Ending{SIGABRT, true}))));

  plan("hold");
  EXPECT_EQ(ask("--restart-controller"), 0);
  EXPECT_TRUE(controllerSays("stands")) << supervisor_->output();
  EXPECT_EQ(ask("--stop-controller"), 0);
  EXPECT_THAT(said_, HasSubstr(std::string{"walk"} + messages::kStopped));
  EXPECT_THAT(controllerLog(), HasSubstr("end requested"));
  EXPECT_EQ(status().controller_pid, 0);
  EXPECT_TRUE(within(seconds{8}, [&] { return sensors().safety.state == State::kLimp; }));
  std::this_thread::sleep_for(milliseconds{1500});  // the robot sits now
  EXPECT_EQ(status().controller_pid, 0);            // it stays stopped
}

TEST_F(Home, AKilledSupervisorEndsItsChildrenNormally) {
  startVirtualRobot();
  plan("hold");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  const Status before = status();
  supervisor_->kill(SIGKILL);
  EXPECT_TRUE(within(seconds{10}, [&] { return runtime::FileLock::holder(runtime::RuntimeFiles{}.loop_lock) == 0; }));
  EXPECT_TRUE(within(seconds{2}, [&] { return kill(before.controller_pid, 0) != 0; }));
  const Registers robot = registers();
  EXPECT_EQ(robot.silent, 0);
  EXPECT_EQ(robot.stiff, 0);
  EXPECT_LT(robot.furthest, 0.1);
}

TEST_F(Home, StopEndsEvenAnUnresponsiveController) {
  startVirtualRobot();
  plan("unresponsive");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  Program second{{program("darwinop-supervisor"), "--home", file("home")}, file("second.txt")};
  EXPECT_EQ(second.wait(seconds{5}), 1);
  EXPECT_THAT(second.output(), HasSubstr("(pid " + std::to_string(supervisor_->pid()) + ")"));
  EXPECT_EQ(ask("--stop"), 0) << said_;
  EXPECT_EQ(supervisor_->wait(seconds{1}), 0) << supervisor_->output();
  EXPECT_THAT(supervisor_->output(), HasSubstr(std::string{" 3 s"} + messages::kKilled));
  EXPECT_TRUE(status().at_rest);
  const Registers robot = registers();
  EXPECT_EQ(robot.stiff, 0);
  EXPECT_LT(robot.furthest, 0.1);
}

TEST_F(Home, TheDefaultControllerWaitsUntilTheRobotSitsUpright) {
  startVirtualRobot("0 fallen front for 3\n");
  plan("once");
  startSupervisor();
  ASSERT_TRUE(says(messages::kWaitingForPose)) << supervisor_->output();
  Program pose{{program("darwinop-runtime"), "--check-pose"}, file("pose.txt")};
  EXPECT_EQ(pose.wait(seconds{5}), 3);
  EXPECT_THAT(pose.output(), HasSubstr(safety::kNotUpright));
  ASSERT_TRUE(says(std::string{"walk"} + messages::kEndedByItself)) << supervisor_->output();
  const std::string output = supervisor_->output();
  EXPECT_EQ(output.find(messages::kWaitingForPose), output.rfind(messages::kWaitingForPose));
  EXPECT_THAT(controllerLog(), HasSubstr("plan once"));
  Program again{{program("darwinop-runtime"), "--check-pose"}, file("pose.txt")};
  EXPECT_EQ(again.wait(seconds{5}), 0);
  EXPECT_THAT(again.output(), Not(HasSubstr(safety::kNotUpright)));
}

TEST_F(Home, AnInvalidRobotIniIsReportedOnceAndBlocksTheRuntime) {
  startVirtualRobot();
  const std::string sound = "[Robot]\nport = " + port() + "\n";
  std::ofstream{file("home/robot.ini")} << sound << "speed = 3\n";
  startSupervisor();
  ASSERT_TRUE(says("robot.ini, line 3: [Robot] speed = 3: ")) << supervisor_->output();
  std::this_thread::sleep_for(milliseconds{2500});  // retried after 2 s
  const std::string output = supervisor_->output();
  EXPECT_EQ(output.find("line 3: "), output.rfind("line 3: ")) << output;
  EXPECT_EQ(status().runtime_pid, 0);
  EXPECT_EQ(ask("--status"), 0);
  EXPECT_THAT(said_, HasSubstr("line 3"));

  std::ofstream{file("home/robot.ini")} << sound;
  EXPECT_EQ(ask("--restart-controller"), 0) << said_;
  EXPECT_TRUE(says(messages::kRuntimeReady)) << supervisor_->output();
  EXPECT_EQ(ask("--stop"), 0) << said_;
  EXPECT_TRUE(says(std::string{"supervisor: "} + messages::kEnded + messages::kAtRest)) << supervisor_->output();
}

/// Some joint gets goals, or was polled after that cycle and had torque.
bool anyTorqueSince(std::uint64_t cycle, const Sensors& seen) {
  EXPECT_NE(seen.cycle, 0U) << "no image was read";
  return std::ranges::any_of(seen.joint, [&](const JointSensors& j) {
    const bool looked_at = j.polled.ever() && j.polled.age + cycle < seen.cycle;
    return j.driven || (looked_at && j.torque_enabled);
  });
}

/// The fault script must wait longer than a busy machine needs for the start pose and all that follows MODE.
TEST_F(Home, AfterModeTheRobotStaysLimpUntilStartIsPressed) {
  startVirtualRobot("15 button mode for 0.6\n35 button start for 0.6\n");
  plan("sit");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands", seconds{14})) << supervisor_->output() << controllerLog();
  ASSERT_TRUE(says(waitingFor(Fault::kReleasedByButton), seconds{15})) << supervisor_->output();
  EXPECT_EQ(ask("--status"), 0);
  EXPECT_THAT(said_, HasSubstr(messages::kHowToReset));
  EXPECT_EQ(status().crashes, 0U);
  constexpr std::uint8_t kStart = 2;
  bool torque = false, is_start_pressed = false;
  const std::uint64_t released = sensors().cycle + 1;
  // Only START may end this, at 35 s: longer than the pause before a restart and the second in the start pose.
  ASSERT_TRUE(within(seconds{30}, [&] {
    const Sensors seen = sensors();
    is_start_pressed = (seen.board.buttons & kStart) != 0;
    const bool is_released = seen.safety.active[safety::rowIndex(Fault::kReleasedByButton)];
    torque = torque || anyTorqueSince(released, seen);
    return is_start_pressed || !is_released;
  }));
  EXPECT_TRUE(is_start_pressed) << "the release ended by itself";
  EXPECT_FALSE(torque);
  ASSERT_TRUE(within(seconds{40}, [&] {
    const std::string log = controllerLog();
    return log.find("stands") != log.rfind("stands");
  })) << supervisor_->output();
}

TEST_F(Home, AfterAnOperatorsReleaseItWaitsForAReset) {
  startVirtualRobot();
  plan("sit");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  Program release{{program("darwinop-runtime"), "--release"}, file("release.txt")};
  EXPECT_EQ(release.wait(seconds{5}), 0);
  ASSERT_TRUE(says(waitingFor(Fault::kReleasedByOperator))) << supervisor_->output();
  const std::uint64_t released = sensors().cycle + 1;
  std::this_thread::sleep_for(milliseconds{4000});
  EXPECT_FALSE(anyTorqueSince(released, sensors()));
  EXPECT_EQ(status().controller_pid, 0);

  // Killed and restarted by a program, like systemd. Without the record only the release keeps the robot limp.
  supervisor_->kill(SIGKILL);
  EXPECT_TRUE(within(seconds{20}, [&] { return runtime::FileLock::holder(runtime::RuntimeFiles{}.loop_lock) == 0; }));
  forgetRecord();
  startSupervisor();
  ASSERT_TRUE(says(waitingFor(Fault::kReleasedByOperator))) << supervisor_->output();
  std::this_thread::sleep_for(milliseconds{2500});
  EXPECT_FALSE(anyTorqueSince(0, sensors()));

  EXPECT_EQ(ask("--restart-controller"), 0);
  EXPECT_TRUE(within(seconds{20}, [&] { return sensors().safety.state == State::kDriven; })) << supervisor_->output();
}

/// The start-up probe switches servo power on, so no loop sees that it was off.
TEST_F(Home, AfterAResetWhileNoLoopRanItWaitsForAPerson) {
  startVirtualRobot();
  plan("sit");  // a robot that has to be set down first would not be driven anyway
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  supervisor_->kill(SIGSTOP);  // no rescue
  const Status before = status();
  kill(before.runtime_pid, SIGKILL);
  kill(before.controller_pid, SIGKILL);
  supervisor_->kill(SIGKILL);
  supervisor_->wait(seconds{5});
  EXPECT_TRUE(within(seconds{5}, [&] { return runtime::FileLock::holder(runtime::RuntimeFiles{}.loop_lock) == 0; }));
  pressReset();

  forgetRecord();
  startSupervisor();
  ASSERT_TRUE(says(waitingFor(Fault::kReleasedByOperator))) << supervisor_->output();
  std::this_thread::sleep_for(milliseconds{2500});
  EXPECT_FALSE(anyTorqueSince(0, sensors()));
  EXPECT_EQ(ask("--restart-controller"), 0);
  EXPECT_TRUE(within(seconds{20}, [&] { return sensors().safety.state == State::kDriven; })) << supervisor_->output();
}

TEST_F(Home, ARobotThatIsFoundStandingIsBroughtToRestAtTheEnd) {
  startVirtualRobot();
  standByHand();
  startSupervisor();  // without a default controller
  ASSERT_TRUE(says(messages::kRuntimeReady)) << supervisor_->output();
  EXPECT_TRUE(within(seconds{5}, [&] { return sensors().safety.state == State::kFoundStiff; }));
  EXPECT_EQ(ask("--stop"), 0) << said_;
  EXPECT_TRUE(says(std::string{"supervisor: "} + messages::kEnded + messages::kAtRest)) << supervisor_->output();
  const Registers robot = registers();
  EXPECT_EQ(robot.silent, 0);
  EXPECT_EQ(robot.stiff, 0);
  EXPECT_LT(robot.furthest, 0.1);
}

TEST_F(Home, ARobotFoundStandingSkipsThePoseCheck) {
  startVirtualRobot();
  standByHand();
  plan("hold");
  startSupervisor();
  ASSERT_TRUE(controllerSays("stands")) << supervisor_->output() << controllerLog();
  EXPECT_EQ(supervisor_->output().find(messages::kWaitingForPose), std::string::npos);
  EXPECT_EQ(ask("--stop"), 0) << said_;
  EXPECT_EQ(registers().stiff, 0);
}

TEST_F(Home, WithoutASupervisorCommandsReportThat) {
  EXPECT_EQ(ask("--status"), 1);
  EXPECT_EQ(ask("--stop"), 0);
  EXPECT_EQ(ask("--stop-controller"), 1);
  EXPECT_EQ(ask("--restart-controller"), 1);
  EXPECT_THAT(said_, HasSubstr(messages::kNoSupervisor));
}

}  // namespace
}  // namespace darwinop::supervisor
