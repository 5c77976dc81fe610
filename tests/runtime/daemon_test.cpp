// The loop in a process of its own: who may drive, and what happens when one of the processes is killed.
#include "runtime/daemon.hpp"

#include <gmock/gmock.h>
#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iostream>
#include <thread>
#include <tuple>

#include "daemon_fixture.hpp"
#include "runtime/daemon_link.hpp"
#include "runtime/fault_announcer.hpp"
#include "runtime/messages.hpp"
#include "runtime/operator.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::runtime {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(DaemonTest, LetsAControllerDrive) {
  DaemonLink link{files_};
  drive(link, 0.2, stop_);
  EXPECT_EQ(link.period(), 4ms);
  EXPECT_EQ(link.sensors().safety.state, State::kDriven);
}

TEST_F(DaemonTest, RefusesASecondControllerAndNamesTheFirst) {
  const Child first{[this] { static const DaemonLink link{files_}; }};
  EXPECT_THAT(refusal(), HasSubstr("(pid " + std::to_string(first.pid()) + ")"));
}

TEST_F(DaemonTest, IsTheOnlyOneOfItsName) {
  try {
    claimRuntime(files_, getgid());
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("(pid " + std::to_string(child_.pid()) + ")"));
  }
}

TEST_F(DaemonTest, GoesOnWhenItsControllerIsKilledAndTheNextOneTakesOverWithoutAJump) {
  Child controller{[this] {
    static DaemonLink link{files_};
    drive(link, 0.5, stop_);
  }};
  controller.kill(SIGKILL);
  const Exchange observer = attachToDaemon(files_);
  Sensors before;
  ASSERT_TRUE(observer.block().sensors.read(before));
  EXPECT_NEAR(before.joint[index(Joint::kNeck)].position.value, 0.5, 1e-3) << "held where the dead one left it";

  DaemonLink next{files_};
  double last = before.joint[index(Joint::kNeck)].position.value;
  for (int i = 0; i < 400 && last > -0.4; ++i) {
    next.publish(neckTo(-0.5));
    ASSERT_TRUE(next.waitForCycle(next.sensors().cycle + 1, stop_));
    const Sensors seen = next.sensors();
    const double neck = seen.joint[index(Joint::kNeck)].position.value;
    const auto cycles = static_cast<double>(seen.cycle - before.cycle);
    EXPECT_LE(std::abs(neck - last), cycles * 0.004 * 12.26 + 1e-6) << "no faster than a joint may move";
    last = neck;
    before = seen;
  }
  EXPECT_LT(last, -0.4);
  EXPECT_EQ(before.safety.session, 2u);
}

TEST_F(DaemonTest, ItsDeathEndsTheControllersStepWithinASecond) {
  DaemonLink link{files_};
  drive(link, 0.1, stop_);
  child_.kill(SIGKILL);
  const Nanos killed = link.now();
  EXPECT_FALSE(link.waitForCycle(link.sensors().cycle + 1000, stop_));
  EXPECT_LT(link.now() - killed, 1s);
  EXPECT_THAT(link.whyEnded(), HasSubstr(messages::kRuntimeDied));
  EXPECT_EQ(daemonPid(files_), 0);
  EXPECT_THAT(refusal(), HasSubstr(messages::kRuntimeHasEnded));
}

TEST_F(DaemonTest, ASecondDaemonReplacesADeadOneAndTheOldControllerIsNotified) {
  DaemonLink old{files_};
  drive(old, 0.1, stop_);
  child_.kill(SIGKILL);
  std::unique_ptr<Daemon> daemon;
  const Child next{[&] { serve(files_, daemon); }};
  EXPECT_EQ(daemonPid(files_), next.pid());
  EXPECT_FALSE(old.waitForCycle(old.sensors().cycle + 1000, stop_)) << "the new loop is not the old one";
  EXPECT_THAT(old.whyEnded(), HasSubstr(messages::kRuntimeDied));
}

TEST_F(DaemonTest, OnRequestItEndsTheControllerAndLeavesTheRobotLimp) {
  DaemonLink link{files_};
  drive(link, 0.1, stop_);
  const Exchange observer = attachToDaemon(files_);
  kill(child_.pid(), SIGTERM);
  while (link.waitForCycle(link.sensors().cycle + 1, stop_)) link.publish(neckTo(0.1));
  EXPECT_EQ(link.whyEnded(), messages::kRuntimeEnds);
  child_.kill(SIGCONT);  // waits until it is gone
  Sensors last;
  ASSERT_TRUE(observer.block().sensors.read(last));
  EXPECT_EQ(last.safety.state, State::kLimp);
  EXPECT_THAT(refusal(), HasSubstr(messages::kNoRuntime + files_.exchange));
}

/// Nothing would watch the robot afterwards.
TEST_F(DaemonTest, ASessionThatHoldsAtItsEndDoesNotKeepTheRobotUpWhenTheDaemonEnds) {
  DaemonLink link{files_};
  safety::Config holds;
  holds.on_exit = safety::OnExit::kHold;
  link.setSafety(holds);
  drive(link, 0.1, stop_);
  kill(child_.pid(), SIGTERM);
  while (link.waitForCycle(link.sensors().cycle + 1, stop_)) link.publish(neckTo(0.1));
  EXPECT_EQ(child_.exitStatus(), 0) << "the robot is limp";
}

TEST_F(DaemonTest, OnRequestTheControllerMayFinishBeforeItEnds) {
  auto link = std::make_unique<DaemonLink>(files_);
  drive(*link, 0.1, stop_);
  kill(child_.pid(), SIGTERM);
  while (link->waitForCycle(link->sensors().cycle + 1, stop_)) link->publish(neckTo(0.1));
  EXPECT_EQ(link->whyEnded(), messages::kRuntimeEnds);
  drive(*link, 0.2, stop_);
  link.reset();
  EXPECT_EQ(child_.exitStatus(), 0) << "the robot is limp";
}

TEST_F(DaemonTest, ReportsAFaultWhenItBeginsAndWhenItIsOver) {
  testing::internal::CaptureStderr();
  const RuntimeFiles files{folder_ / "other"};
  std::unique_ptr<Daemon> daemon;
  {
    const Child other{[&] { serve(files, daemon); }};
    DaemonLink link{files};
    drive(link, 0.1, stop_);
    std::this_thread::sleep_for(800ms);  // 500 ms make a stalled controller
    drive(link, 0.2, stop_);
    std::this_thread::sleep_for(200ms);
  }
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_THAT(text, HasSubstr("darwinop: fault 40 controller_stalled: "));
  EXPECT_THAT(text, HasSubstr(std::string{"darwinop: fault 40 controller_stalled"} + FaultAnnouncer::kIsOver));
}

class SomebodyShortens : public DaemonTest, public testing::WithParamInterface<std::tuple<const char*, off_t>> {};

TEST_P(SomebodyShortens, TheSharedMemoryAndTheRobotComesToRestAndBothSidesSayWhy) {
  const auto [ending, length] = GetParam();
  DaemonLink link{files_};
  drive(link, 0.2, stop_);
  ASSERT_EQ(truncate((files_.exchange + ending).c_str(), length), 0);
  const Nanos end = link.now() + 20s;
  while (link.now() < end && link.waitForCycle(link.sensors().cycle + 1, stop_)) link.publish(neckTo(0.2));
  EXPECT_THAT(link.whyEnded(), testing::AnyOf(kExchangeLost, messages::kRuntimeEnds));
  EXPECT_EQ(child_.exitStatus(), kLostAtRest) << "neither killed nor with joints under torque";
  EXPECT_THAT(refusal(), HasSubstr(messages::kNoRuntime + files_.exchange));
}

INSTANTIATE_TEST_SUITE_P(Each, SomebodyShortens,
                         testing::Combine(testing::Values("", ".commands"), testing::Values(off_t{0}, off_t{100})));

TEST_F(DaemonTest, AStrayWriteOfOneControllerDoesNotMakeTheNextOneWait) {
  {
    const Exchange stray = attachToDaemon(files_);
    std::memset(static_cast<void*>(&stray.commands()), 0xA5, sizeof(CommandBlock));
  }
  std::this_thread::sleep_for(20ms);  // the loop repairs what is its own
  DaemonLink next{files_};
  drive(next, 0.2, stop_);
}

TEST_F(DaemonTest, AUserWhoMayNotUseItGetsAnError) {
  const TemporaryFolder folder;
  chmod((folder / "").c_str(), 0777);
  chmod((folder_ / "").c_str(), 0755);
  const std::string said = folder / "said";
  const Child nobody{[&] {
    if (getuid() == 0 && setgroups(0, nullptr) == 0 && setgid(65534) == 0 && setuid(65534) == 0)
      std::ofstream{said} << daemonPid(files_) << ' ' << refusal();
  }};
  std::ifstream in{said};
  if (!in) GTEST_SKIP() << "only root can become another user";
  const std::string text{std::istreambuf_iterator<char>{in}, {}};
  EXPECT_THAT(text, StartsWith(std::string{"-1 "} + messages::kOtherUsersRuntime));
  EXPECT_THAT(text, HasSubstr(" rm " + files_.exchange));
}

TEST_F(DaemonTest, StatusShowsWhoDrivesAndHowTheLoopFares) {
  EXPECT_THAT(daemonStatus(files_), HasSubstr("driver        none"));
  const Child controller{[this] {
    static DaemonLink link{files_};
    drive(link, 0.1, stop_);
  }};
  const std::string status = daemonStatus(files_);
  EXPECT_THAT(status, HasSubstr("pid " + std::to_string(child_.pid()) + ", darwin-op on a fake"));
  EXPECT_THAT(status, HasSubstr("driver        pid " + std::to_string(controller.pid()) + ", session 1"));
  EXPECT_THAT(status, HasSubstr("state         driven"));
  EXPECT_THAT(status, HasSubstr("battery       11.8 V"));
  EXPECT_THAT(status, HasSubstr("stale devices none"));
}

}  // namespace
}  // namespace darwinop::runtime
