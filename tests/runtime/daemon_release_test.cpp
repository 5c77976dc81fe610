// A person releases the robot under a daemon or resets its faults, and what a daemon finds of an earlier release.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <csignal>

#include "daemon_fixture.hpp"
#include "runtime/messages.hpp"
#include "runtime/operator.hpp"

namespace darwinop::runtime {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST_F(DaemonTest, AnOperatorCanReleaseTheRobotUnderAController) {
  DaemonLink link{files_};
  drive(link, 0.1, stop_);
  releaseRobot(files_);
  EXPECT_FALSE(link.waitForCycle(link.sensors().cycle + 1000, stop_));
  EXPECT_EQ(link.whyEnded(), messages::kRobotReleased);
  const Exchange observer = attachToDaemon(files_);
  Sensors seen;
  for (int i = 0; i < 500 && seen.safety.active.none(); ++i) {
    std::this_thread::sleep_for(10ms);
    (void)observer.block().sensors.read(seen);
  }
  EXPECT_THAT(daemonStatus(files_), HasSubstr("fault         33 released_by_operator"));
}

TEST_F(DaemonTest, ARobotThatWasReleasedStaysSoOverAKilledDaemonUntilAPersonActs) {
  const auto comes = [this](Fault fault) {
    for (int i = 0; i < 500; ++i, std::this_thread::sleep_for(10ms))
      if (daemonStatus(files_).find(" " + std::string{row(fault).name} + ":") != std::string::npos) return true;
    return false;
  };
  releaseRobot(files_);
  ASSERT_TRUE(comes(Fault::kReleasedByOperator));
  ASSERT_TRUE(recorded(files_.released, true));
  child_.kill(SIGKILL);

  std::unique_ptr<Daemon> daemon;
  const Child again{[&] { serve(files_, daemon); }};
  EXPECT_TRUE(comes(Fault::kReleasedByOperator));
  resetFaults(files_);
  EXPECT_TRUE(recorded(files_.released, false));
  EXPECT_THAT(daemonStatus(files_), ContainsRegex("faults +none\n"));
}

TEST_F(DaemonTest, ASessionThatBeginsBeforeTheFirstCycleEndsAnEarlierRelease) {
  releaseRobot(files_);
  ASSERT_TRUE(recorded(files_.released, true));
  child_.kill(SIGKILL);
  std::unique_ptr<Daemon> daemon;
  const Child again{[&] { serve(files_, daemon, {.power = true, .unplugged = false, .first_cycle = 1000ms}); }};
  DaemonLink link{files_};
  ASSERT_EQ(link.sensors().cycle, 0U) << "too slow for this test";
  drive(link, 0.1, stop_);
  EXPECT_TRUE(recorded(files_.released, false));
}

TEST_F(DaemonTest, ARobotWhoseCableIsOutIsNotReportedAsReleased) {
  child_.kill(SIGKILL);
  std::unique_ptr<Daemon> daemon;
  const Child again{[&] { serve(files_, daemon, {.power = true, .unplugged = true}); }};
  try {
    releaseRobot(files_);
    ADD_FAILURE() << "its servos hold their last goals";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), messages::kReleasedInSilence);
  }
}

std::string errorOf(void (*request)(const RuntimeFiles&), const RuntimeFiles& files) {
  try {
    request(files);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST_F(DaemonTest, AResetReportsAFaultWhoseCausePersistsAndClearsTheOthers) {
  child_.kill(SIGKILL);
  std::unique_ptr<Daemon> daemon;
  const Child again{[&] { serve(files_, daemon, {.power = true, .unplugged = false, .volt = 9.5}); }};
  releaseRobot(files_);
  for (int i = 0; i < 500 && daemonStatus(files_).find("battery_empty:") == std::string::npos; ++i)
    std::this_thread::sleep_for(10ms);
  const FaultRow& empty = row(Fault::kBatteryEmpty);
  EXPECT_THAT(errorOf(resetFaults, files_),
              AllOf(StartsWith(messages::kCausesPersist), HasSubstr(std::string{empty.meaning}),
                    HasSubstr(std::string{empty.remedy}), Not(HasSubstr("released_by_operator"))));
  EXPECT_EQ(errorOf(requestFaultReset, files_), "") << "it does not wait";
}

TEST_F(DaemonTest, AResetFailsWhileTheLoopHangs) {
  releaseRobot(files_);
  kill(child_.pid(), SIGSTOP);
  EXPECT_THAT(errorOf(resetFaults, files_), HasSubstr(messages::kLoopHangs));
  kill(child_.pid(), SIGCONT);
}

TEST_F(DaemonTest, AFifoInThePlaceOfItsRecordMeansAReleaseUntilAPersonActs) {
  child_.kill(SIGKILL);
  ASSERT_EQ(unlink(files_.released.c_str()), 0);
  ASSERT_EQ(mkfifo(files_.released.c_str(), 0666), 0);
  std::unique_ptr<Daemon> daemon;
  const Child again{[&] { serve(files_, daemon); }};
  for (int i = 0; i < 500 && daemonStatus(files_).find("released_by_operator:") == std::string::npos; ++i)
    std::this_thread::sleep_for(10ms);
  EXPECT_THAT(daemonStatus(files_), HasSubstr("released_by_operator:"));
  resetFaults(files_);
  EXPECT_TRUE(recorded(files_.released, false));
}

/// RESET was pressed while no loop ran, or so shortly before that the dead one could not notice.
TEST_F(DaemonTest, ServoPowerThatIsFoundOffAfterADaemonThatDroveIsARelease) {
  const auto status_of = [this](bool held) {
    std::unique_ptr<Daemon> daemon;
    if (!held) RobotNotes::forget(files_);
    const Child next{[&] { serve(files_, daemon, {.power = false, .unplugged = false}); }};
    for (int i = 0; i < 500 && daemonStatus(files_).find("limp") == std::string::npos; ++i)
      std::this_thread::sleep_for(10ms);
    std::this_thread::sleep_for(100ms);
    return daemonStatus(files_);
  };
  {
    DaemonLink link{files_};
    drive(link, 0.2, stop_);
    ASSERT_TRUE(recorded(files_.held, true));
    child_.kill(SIGKILL);
  }
  EXPECT_THAT(status_of(true), HasSubstr("board_reset"));
  EXPECT_THAT(status_of(false), Not(HasSubstr("board_reset"))) << "a board that was just switched on";
}

}  // namespace
}  // namespace darwinop::runtime
