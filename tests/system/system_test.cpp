// The whole chain with real processes on a real pty: what a user starts, and what happens when parts of it fail.
#include <gmock/gmock.h>

#include <string>
#include <thread>
#include <vector>

#include "system/rig.hpp"
#include "virtual_robot_report.hpp"

namespace darwinop {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;

constexpr double kDriven = 4;  // safety.state

using WholeChain = Rig;

class Period : public Rig, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Ms, Period, testing::Values(16, 8));

TEST_P(Period, ACycleIsOneSyncWriteAndOneBulkReadCloseToTheirWireTime) {
  startVirtualRobot();
  const std::string output = run(port(), {"--period", std::to_string(GetParam())}, {"400"});
  const auto report = reportLine(output);
  const auto board = countersOfVirtualRobot();
  EXPECT_LE(report.at("bus_ratio"), 1.10) << output;
  EXPECT_GE(report.at("cycles"), 400) << output;
  EXPECT_LE(report.at("overruns"), 0.02 * report.at("cycles")) << output;
  constexpr double kStartUp = 100;  // the check before the loop tries both, at most so often on a busy machine
  EXPECT_LE(board.at(app::kBulkReads), report.at("cycles") + kStartUp);
  EXPECT_LE(board.at(app::kSyncWrites), report.at("cycles") + kStartUp);
  EXPECT_GE(board.at(app::kBulkReads), 0.95 * report.at("cycles"));
}

TEST_F(WholeChain, AnUnpluggedCableComesBackWithoutRestartingTheController) {
  startVirtualRobot("6 unplug for 1\n");
  const std::string output = run(port(), {"--record", file("log.csv")}, {"600"});
  EXPECT_THAT(output, HasSubstr("done"));
  EXPECT_THAT(output, HasSubstr("reconnects 1"));
  const Recording log{file("log.csv")};
  std::size_t silent = 0;
  for (std::size_t i = 0; i < log.rows(); ++i) silent += std::isnan(log.at(i, "Neck.position [rad]")) ? 1 : 0;
  EXPECT_GT(silent, 40U);  // a second without values, and they are absent, not old
  EXPECT_LT(silent, 200U);
}

TEST_F(WholeChain, ADeadServoOfAnArmIsNamedAndTheOthersGoOn) {
  startVirtualRobot("0 dead ArmUpperR\n");
  const std::string output = run(port(), {"--record", file("log.csv")}, {"100"});
  EXPECT_THAT(output, HasSubstr("ArmUpperR"));
  const Recording log{file("log.csv")};
  std::size_t driven = 0, answered = 0;
  for (std::size_t i = 0; i < log.rows(); ++i) {
    if (log.at(i, "safety.state") != kDriven) continue;
    ++driven;
    EXPECT_TRUE(std::isnan(log.at(i, "ArmUpperR.position [rad]")));
    // The neck is read after both; a busy machine may read a whole cycle too late.
    if (std::isnan(log.at(i, "Neck.position [rad]"))) continue;
    ++answered;
    EXPECT_FALSE(std::isnan(log.at(i, "ArmLowerR.position [rad]"))) << "row " << i;
  }
  EXPECT_GE(driven, 100U);
  EXPECT_GT(answered, driven / 2);
}

class RefusedRobot : public Rig, public testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(Servos, RefusedRobot,
                         testing::Values("LegLowerR=wheel", "Neck=wheel", "LegLowerR=multi-turn", "ArmLowerL=model:12"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
                           return name;
                         });

// Judged at the servos: none of them ever had torque.
TEST_P(RefusedRobot, IsDrivenByNobodyAndSaysWhatToDo) {
  startVirtualRobot("", {"--servo", GetParam()});
  const std::string joint = std::string{GetParam()}.substr(0, std::string{GetParam()}.find('='));
  const std::vector<std::string> ways[] = {
      {program("darwinop-runtime"), "--robot", port()},
      {program("darwinop-runtime"), "--robot", port(), "--wait"},
      {program("darwinop-run"), "--robot", port(), controller(), "100"},
      {program("darwinop-doctor"), "--robot", port()},
  };
  for (const std::vector<std::string>& command : ways) {
    Program way{command, file("way.txt")};
    EXPECT_EQ(way.wait(seconds{60}), 1) << way.output();
    EXPECT_THAT(way.output(), testing::AllOf(HasSubstr("FAIL  servo"), HasSubstr(joint), HasSubstr("-> ")));
  }
  EXPECT_EQ(countersOfVirtualRobot().at(app::kTorqueSwitchedOn), 0);
}

TEST_F(WholeChain, ASilentKneeIsWaitedForAndDrivenWithoutOnlyWhenRobotIniNamesIt) {
  startVirtualRobot("0 dead LegLowerR for 6\n");
  Program refused{{program("darwinop-runtime"), "--robot", port()}, file("refused.txt")};
  EXPECT_EQ(refused.wait(seconds{60}), 1) << refused.output();
  EXPECT_THAT(refused.output(), HasSubstr("LegLowerR (right knee): silent"));

  std::ofstream{file("robot.ini")} << "[Robot]\nabsent = LegLowerR\n";
  setenv("DARWINOP_ROBOT_FILE", file("robot.ini").c_str(), 1);
  {
    Program without{{program("darwinop-runtime"), "--robot", port()}, file("without.txt")};
    EXPECT_TRUE(without.says("ready:", seconds{20})) << without.output();
    EXPECT_THAT(without.output(), HasSubstr("absent: LegLowerR"));
    without.kill(SIGTERM);
    EXPECT_EQ(without.wait(seconds{20}), 0);
    EXPECT_EQ(without.output().find("servo_silent"), std::string::npos) << without.output();
  }
  unsetenv("DARWINOP_ROBOT_FILE");

  Program waiting{{program("darwinop-runtime"), "--robot", port(), "--wait"}, file("waiting.txt")};
  EXPECT_TRUE(waiting.says("ready:", seconds{60})) << "when the knee is back: " << waiting.output();
  waiting.kill(SIGTERM);
  EXPECT_EQ(waiting.wait(seconds{20}), 0);
}

TEST_F(WholeChain, AKilledControllerLeavesTheRobotToTheDaemonAndTheNextOneTakesOverWithoutAJump) {
  startVirtualRobot();
  Program daemon{{program("darwinop-runtime"), "--robot", port(), "--record", file("log.csv")}, file("daemon.txt")};
  ASSERT_TRUE(daemon.says("ready:", seconds{20})) << daemon.output();
  setenv("DARWINOP_ROBOT", "runtime", 1);
  {
    Program first{{controller(), "100000"}, file("first.txt")};
    ASSERT_TRUE(first.says("ready", seconds{20})) << first.output();
    Program second{{controller(), "10"}, file("second.txt")};
    EXPECT_EQ(second.wait(seconds{10}), 1);
    EXPECT_THAT(second.output(), HasSubstr(std::to_string(first.pid())));
    std::this_thread::sleep_for(seconds{1});
    first.kill(SIGKILL);
    EXPECT_EQ(first.wait(seconds{5}), 128 + SIGKILL);
  }
  ASSERT_TRUE(daemon.says("controller_stalled", seconds{20})) << daemon.output();
  Program next{{controller(), "50"}, file("next.txt")};
  EXPECT_EQ(next.wait(seconds{20}), 0) << next.output();
  unsetenv("DARWINOP_ROBOT");
  daemon.kill(SIGTERM);
  EXPECT_EQ(daemon.wait(seconds{20}), 0) << daemon.output();

  const Recording log{file("log.csv")};
  bool held = false;
  int takeovers = 0;
  for (std::size_t i = 1; i < log.rows(); ++i) {
    held = held || log.at(i, "safety.state") == 5;
    const double goal = log.at(i, "Neck.commanded [rad]"), before = log.at(i - 1, "Neck.commanded [rad]");
    if (std::isnan(goal)) continue;  // not driven
    if (std::isnan(before)) {
      ++takeovers;
      EXPECT_NEAR(goal, log.at(i - 1, "Neck.position [rad]"), 0.02) << "row " << i;
    } else {
      EXPECT_LE(std::abs(goal - before), 12.26 * 0.016 + 1e-9) << "row " << i;
    }
  }
  EXPECT_TRUE(held);
  EXPECT_GE(takeovers, 2) << "by the first controller and by the next";
}

TEST_F(WholeChain, AKilledDaemonEndsTheControllerWithASentence) {
  startVirtualRobot();
  Program daemon{{program("darwinop-runtime"), "--robot", port()}, file("daemon.txt")};
  ASSERT_TRUE(daemon.says("ready:", seconds{20})) << daemon.output();
  setenv("DARWINOP_ROBOT", "runtime", 1);
  Program driving{{controller(), "100000"}, file("controller.txt")};
  unsetenv("DARWINOP_ROBOT");
  ASSERT_TRUE(driving.says("ready", seconds{20})) << driving.output();
  daemon.kill(SIGKILL);
  EXPECT_EQ(driving.wait(seconds{5}), 0) << driving.output();
  EXPECT_THAT(driving.output(), HasSubstr("step() = -1"));
  EXPECT_THAT(driving.output(), HasSubstr("runtime"));
}

/// The controller itself ends well: what is wrong is the robot that nothing watches.
TEST_F(WholeChain, ADaemonThatDiesDuringARunMakesItFail) {
  startVirtualRobot();
  Program daemon{{program("darwinop-runtime"), "--robot", port()}, file("daemon.txt")};
  ASSERT_TRUE(daemon.says("ready:", seconds{20})) << daemon.output();
  Program running{{program("darwinop-run"), "--robot", "runtime", controller(), "100000"}, file("run.txt")};
  ASSERT_TRUE(running.says("ready", seconds{20})) << running.output();
  daemon.kill(SIGKILL);
  EXPECT_EQ(running.wait(seconds{10}), 1) << running.output();
  EXPECT_THAT(running.output(), HasSubstr("report: "));
}

TEST_F(WholeChain, CtrlCEndsAControllerNormallyAndTheReportIsTheLastLine) {
  startVirtualRobot();
  Program running{{program("darwinop-run"), "--robot", port(), controller(), "100000"}, file("run.txt")};
  ASSERT_TRUE(running.says("ready", seconds{20})) << running.output();
  running.kill(SIGINT);
  EXPECT_EQ(running.wait(seconds{20}), 0) << running.output();
  const std::string output = running.output();
  EXPECT_THAT(output, HasSubstr("step() = -1"));
  EXPECT_EQ(output.find('\n', output.rfind("report: ")), output.size() - 1);
}

TEST_F(WholeChain, APortThatIsNotThereIsOneSentenceAndAFailure) {
  Program running{{program("darwinop-run"), "--robot", file("nothing"), controller()}, file("run.txt")};
  EXPECT_EQ(running.wait(seconds{20}), 1);
  EXPECT_THAT(running.output(), HasSubstr(" " + file("nothing") + " "));
}

}  // namespace
}  // namespace darwinop
