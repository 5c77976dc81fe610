// Start conditions of the default controller. Time is an argument; the controller is a script that sleeps.
#include "supervisor/default_controller.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "core/conversions.hpp"
#include "runtime/environment.hpp"
#include "runtime/exchange.hpp"
#include "runtime/file_lock.hpp"
#include "safety/fault_book.hpp"
#include "supervisor/messages.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::supervisor {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
namespace fs = std::filesystem;

struct Begin : ::testing::Test {
  TemporaryFolder folder;
  runtime::RuntimeFiles files{folder / "runtime"};
  runtime::Environment robot_file{"DARWINOP_ROBOT_FILE", folder / "robot.ini"};
  DefaultController controller{folder / "", files};
  Nanos now = 100s;

  void SetUp() override {
    fs::create_directories(folder / "log");
    std::ofstream{folder / "robot.ini"} << "[Robot]\ncontroller_user = root\n";  // build machines have no other user
    fs::create_directories(folder / "controllers/walk");
    const std::string program = folder / "controllers/walk/walk";
    std::ofstream{program} << "#!/bin/sh\nexec sleep 100\n";
    fs::permissions(program, fs::perms::owner_all);
    fs::create_symlink("controllers/walk", folder / "default");
  }
  static Sensors sitting(State state = State::kLimp) {
    Sensors seen;
    seen.safety.state = state;
    for (std::size_t i = 0; i < kJoints; ++i) {
      seen.joint[i].motion.received();
      seen.joint[i].position = radFromTicks(kJointTable[i].start);
    }
    seen.board.motion.received();
    seen.board.accelerometer = {MeterPerSec2{0}, MeterPerSec2{0}, MeterPerSec2{9.80665}};
    return seen;
  }
  static Sensors lying() {
    Sensors seen = sitting();
    seen.board.accelerometer = {MeterPerSec2{9.80665}, MeterPerSec2{0}, MeterPerSec2{0}};
    return seen;
  }
  static Sensors with(Fault fault, Sensors seen = sitting()) {
    seen.safety.active.set(safety::rowIndex(fault));
    return seen;
  }
  void letTheProgramDo(const std::string& what) {
    std::ofstream{folder / "controllers/walk/walk"} << "#!/bin/sh\n" << what << '\n';
  }
  /// Steps until the program has ended; processes take real time.
  void lookUntilEnded(const Sensors& seen) {
    for (int i = 0; i < 1000 && runs(); ++i, now += 1ms) {
      std::this_thread::sleep_for(5ms);
      controller.update(seen, now);
    }
  }
  /// Steps every 20 ms, at least once.
  void lookFor(Nanos time, const Sensors& seen) {
    for (const Nanos end = now + time; now < end; now += 20ms) controller.update(seen, now);
  }
  [[nodiscard]] Status status() const {
    Status status;
    controller.report(status, now);
    return status;
  }
  [[nodiscard]] bool runs() const { return status().controller_pid != 0; }
};

TEST_F(Begin, ARobotThatSitsWithinItsLimitsIsInItsStartPose) {
  auto pose = safety::startPose(safety::Config{});
  pose[index(Joint::kLegLowerR)] = Rad{1.7};  // as [Limits] allows
  Sensors seen = sitting();
  seen.joint[index(Joint::kLegLowerR)].position = Rad{1.7};
  const auto starts = [&] {
    for (int i = 0; i < 100; ++i) controller.update(seen, now += 50ms);
    Status status;
    controller.report(status, now);
    return status.controller_pid != 0;
  };
  EXPECT_FALSE(starts());
  controller.startsFrom(pose);
  EXPECT_TRUE(starts());
}

TEST_F(Begin, ALimpRobotMustSitForASecond) {
  lookFor(980ms, sitting());
  EXPECT_FALSE(runs());
  lookFor(60ms, sitting());
  EXPECT_TRUE(runs());
  EXPECT_EQ(status().controller, "walk");
}

TEST_F(Begin, WithoutAUserAccountItIsRejectedOnceAndNotRetried) {
  if (geteuid() != 0) GTEST_SKIP() << "only root starts it as another user";
  std::ofstream{folder / "robot.ini"} << "[Robot]\ncontroller_user = no-such-user\n";
  testing::internal::CaptureStderr();
  lookFor(60s, sitting());
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_FALSE(runs());
  EXPECT_THAT(said, HasSubstr(std::string{"walk"} + messages::kNotStarted));
  EXPECT_THAT(said, HasSubstr("'no-such-user'"));
  EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
}

TEST_F(Begin, AHeldRobotSkipsThePoseCheck) {
  Sensors held = lying();
  held.safety.state = State::kHolding;
  controller.update(held, now);
  EXPECT_TRUE(runs());
}

TEST_F(Begin, ARobotFoundUnderTorqueSkipsThePoseCheckIfALegHolds) {
  Sensors stiff = lying();
  stiff.safety.state = State::kFoundStiff;
  JointSensors& head = stiff.joint[index(Joint::kHead)];
  head.polled.received();
  head.torque_enabled = true;
  lookFor(3s, stiff);
  EXPECT_FALSE(runs()) << "limp legs: a person may hold the robot";
  JointSensors& knee = stiff.joint[index(Joint::kLegLowerL)];
  knee.polled.received();
  knee.torque_enabled = true;
  controller.update(stiff, now);
  EXPECT_TRUE(runs());
}

TEST_F(Begin, ALatchedFaultBlocksTheStartAndStatusReportsIt) {
  for (const FaultRow& fault : kFaultTable) {
    if (!fault.latched) continue;
    lookFor(3s, with(fault.fault));
    EXPECT_FALSE(runs()) << fault.name;
    EXPECT_THAT(status().state, HasSubstr(std::string{fault.meaning}));
    EXPECT_THAT(status().state, HasSubstr(messages::kHowToReset));
  }
  lookFor(1100ms, with(Fault::kBatteryLow));
  EXPECT_TRUE(runs());
}

TEST_F(Begin, EveryStartIsUnattended) {
  letTheProgramDo("echo \"unattended $DARWINOP_UNATTENDED\"");
  lookFor(1100ms, sitting());
  lookUntilEnded(sitting());
  std::stringstream log;
  log << std::ifstream{folder / "log/controller.log"}.rdbuf();
  EXPECT_THAT(log.str(), HasSubstr("unattended 1"));
}

TEST_F(Begin, AnEndByALatchedFaultIsNeitherACrashNorANormalEnd) {
  const fs::path go = folder / "controllers/walk/go";
  for (const std::string how : {"exit 0", "exit 1", "kill -ABRT $$"}) {
    letTheProgramDo("while [ ! -e go ]; do sleep 0.01; done; " + how);
    for (int i = 0; i < 4; ++i) {  // three crashes would be too many
      controller.restart(now);
      fs::remove(go);
      lookFor(1100ms, sitting());
      ASSERT_TRUE(runs());
      std::ofstream{go} << "go";
      lookUntilEnded(with(Fault::kReleasedByButton));
      EXPECT_FALSE(runs());
      EXPECT_EQ(status().crashes, 0U);
      lookFor(10s, with(Fault::kReleasedByButton));
      EXPECT_THAT(status().state, HasSubstr(std::string{row(Fault::kReleasedByButton).meaning}));
      EXPECT_FALSE(status().controller_ended);
    }
    letTheProgramDo("exec sleep 100");
    lookFor(980ms, sitting());
    EXPECT_FALSE(runs()) << "the robot must sit, as before every start";
    lookFor(60ms, sitting());
    EXPECT_TRUE(runs());
    controller.stop(now);
    lookUntilEnded(sitting());
  }
}

TEST_F(Begin, TheSecondRestartsAfterTheRobotLay) {
  lookFor(800ms, sitting());
  lookFor(20ms, lying());
  lookFor(980ms, sitting());
  EXPECT_FALSE(runs());
  lookFor(60ms, sitting());
  EXPECT_TRUE(runs());
}

TEST_F(Begin, TheSecondRestartsAfterASilentBoard) {
  lookFor(800ms, sitting());
  lookFor(10s, sitting(State::kOffline));
  lookFor(980ms, sitting());
  EXPECT_FALSE(runs());
  lookFor(60ms, sitting());
  EXPECT_TRUE(runs());
}

TEST_F(Begin, TheSecondRestartsAfterAnotherController) {
  lookFor(800ms, sitting());
  {
    const auto lease = runtime::FileLock::tryTake(files.drive_lock);
    ASSERT_TRUE(lease);
    lookFor(10s, sitting());
  }
  lookFor(980ms, sitting());
  EXPECT_FALSE(runs());
  lookFor(60ms, sitting());
  EXPECT_TRUE(runs());
}

/// An attempt to take the lease waits for 0.1 s, in which the supervisor's only thread does not watch the runtime.
TEST_F(Begin, OneThatHasFailedDoesNotTryToTakeTheLeaseOfAnotherController) {
  letTheProgramDo("exit 1");
  for (std::size_t crash = 0; crash < RestartPolicy::kCrashes; ++crash) {
    lookFor(RestartPolicy::kPause + 1100ms, sitting());
    lookUntilEnded(sitting());
  }
  ASSERT_THAT(status().state, HasSubstr(messages::kFailed));
  const runtime::Exchange exchange = runtime::Exchange::create(files.exchange);
  const auto loop = runtime::FileLock::tryTake(files.loop_lock), lease = runtime::FileLock::tryTake(files.drive_lock);
  testing::internal::CaptureStderr();
  lookFor(200ms, sitting());
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr(messages::kOtherDrives + runtime::pidText(getpid())));
  EXPECT_THAT(said, testing::Not(HasSubstr(messages::kCannotHold)));
  EXPECT_TRUE(controller.staysEnded());
}

TEST_F(Begin, WithoutADefaultControllerNothingStarts) {
  fs::remove(folder / "default");
  controller.stayEnded(messages::kStaysEnded);  // what the last supervisor recorded, as after every `install --run`
  lookFor(3s, sitting());
  EXPECT_FALSE(runs());
  EXPECT_EQ(status().controller, "");
  EXPECT_FALSE(status().controller_ended);
}

TEST_F(Begin, RootIsRejectedUnlessRobotIniAllowsIt) {
  if (geteuid() != 0) GTEST_SKIP() << "only root's supervisor can start something as root";
  std::ofstream{folder / "robot.ini"} << "[Robot]\ncontroller_user = nobody-like-this\n";
  lookFor(1100ms, sitting());
  EXPECT_FALSE(runs());
}

TEST_F(Begin, OneThatWasStoppedStaysStopped) {
  controller.stop(now);
  lookFor(3s, sitting());
  EXPECT_FALSE(runs());
  EXPECT_TRUE(status().controller_ended);
  controller.restart(now);
  lookFor(1100ms, sitting());
  EXPECT_TRUE(runs());
}

TEST_F(Begin, OneThatIsBeingStoppedStaysEndedUnlessItIsRestarted) {
  lookFor(1100ms, sitting());
  EXPECT_FALSE(controller.staysEnded());
  controller.restart(now);
  ASSERT_TRUE(runs()) << "it gets time to end";
  EXPECT_FALSE(controller.staysEnded());
  controller.stop(now);
  ASSERT_TRUE(runs());
  EXPECT_TRUE(controller.staysEnded());
}

}  // namespace
}  // namespace darwinop::supervisor
