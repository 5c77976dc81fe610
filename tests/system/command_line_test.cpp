// Refusals and questions of the programs, as a user meets them in a terminal.
#include "system/command_line.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "apps/calibrate/joints/messages.hpp"
#include "apps/calibrate/messages.hpp"
#include "hal/replace_file.hpp"
#include "hil-mocks/link_owner.hpp"
#include "motion_messages.hpp"
#include "runtime/environment.hpp"
#include "runtime/file_lock.hpp"
#include "runtime/messages.hpp"
#include "runtime/names.hpp"
#include "support/text_of.hpp"
#include "window/messages.hpp"

namespace darwinop {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST_F(CommandLine, CalibrateWithoutARobotNamesTheRuntimeThatRunsHere) {
  const auto daemon = runtime::FileLock::tryTake(runtime::RuntimeFiles{}.loop_lock);
  ASSERT_TRUE(daemon);
  const std::string pid = std::to_string(getpid());
  for (const char* what : {"imu", "by-hand Neck"}) {
    const Outcome refused = call(std::string{"calibrate "} + what);
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.said, AllOf(HasSubstr(calibrate::messages::kRuntimeRunsHere + pid + ")"),
                                    HasSubstr("`kill " + pid + "`"), HasSubstr("--robot")));
  }
}

TEST_F(CommandLine, CalibrateByHandNeedsHands) {
  const Outcome refused = call("calibrate by-hand --robot twin --yes Neck");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, HasSubstr(calibrate::messages::kYesByHand));
  const Outcome ended = call("calibrate by-hand --robot twin Neck");
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.said, HasSubstr(calibrate::messages::kNoJointRead));
}

TEST_F(CommandLine, CalibrateSaysBeforeItMeasuresThatItCannotWrite) {
  const Outcome refused = call("calibrate imu --robot twin --yes --file none/robot.ini");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, testing::StartsWith(std::string{"darwinop calibrate: "} + kCannotWrite + "none/robot.ini"));
}

TEST_F(CommandLine, CalibrateThatHasNowhereToWriteHasWrittenNothing) {
  const Outcome nowhere = call("calibrate imu --robot twin --yes --seconds 1");
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_THAT(nowhere.said, HasSubstr(calibrate::messages::kNothingWritten));
  EXPECT_EQ(call("calibrate imu --robot twin --yes --seconds 1 --dry-run").status, 0);
}

TEST_F(CommandLine, TheRobotThatCalibrateIsGivenWinsOverTheEnvironment) {
  const runtime::Environment usual{"DARWINOP_ROBOT", "/nonexistent"};
  EXPECT_EQ(call("calibrate imu --robot twin --yes --seconds 1 --dry-run").status, 0);
  EXPECT_EQ(call("calibrate by-hand --robot twin Neck").status, 1);
  const Outcome by_environment = call("calibrate joints --dry-run");
  EXPECT_EQ(by_environment.status, 2);
  EXPECT_THAT(by_environment.said, HasSubstr("/nonexistent"));
}

TEST_F(CommandLine, CalibrateRefusesARobotThatNobodyCanTurn) {
  std::ofstream{file("robot.ini")} << "[Offsets]\nNeck = 0.05\n";
  const runtime::Environment own{"DARWINOP_ROBOT_FILE", file("robot.ini")};
  const Outcome refused = call("calibrate by-hand --robot virtual Neck");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, HasSubstr(calibrate::messages::kNothingToCalibrate));
}

// Its limits and absent joints would not apply while the joints are swept.
TEST_F(CommandLine, CalibrateRefusesARobotWhoseFileDoesNotExist) {
  const Outcome refused = call("calibrate joints --file " + file("new.ini") + " --robot " + file("port"));
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, HasSubstr(file("new.ini") + calibrate::messages::kNoSuchRobotFile));
}

TEST_F(CommandLine, CtrlCDuringASweepEndsCalibrateAsStopped) {
  Program sweeping{{program("darwinop-calibrate"), "joints", "--robot", "twin", "--yes"}, file("calibrate.txt")};
  ASSERT_TRUE(sweeping.says(calibrate::messages::kSweepBegins, std::chrono::seconds{60})) << sweeping.output();
  sweeping.kill(SIGINT);
  EXPECT_EQ(sweeping.wait(std::chrono::seconds{60}), 130);
  EXPECT_THAT(sweeping.output(), AllOf(HasSubstr(calibrate::messages::kStopped),
                                       testing::Not(HasSubstr(calibrate::messages::kNothingSwept))));
}

TEST_F(CommandLine, CtrlCAtAQuestionEndsCalibrateAsStopped) {
  ASSERT_EQ(mkfifo(file("answers").c_str(), 0600), 0);  // no answer comes
  Program asking{{"/bin/sh", "-c", "exec \"$0\" \"$@\" <>" + file("answers"), program("darwinop-calibrate"), "by-hand",
                  "--robot", "twin", "Neck"},
                 file("calibrate.txt")};
  ASSERT_TRUE(asking.says("Neck (", std::chrono::seconds{30})) << asking.output();
  std::optional<int> status;
  for (int tries = 0; tries < 30 && !status; ++tries) {  // one may come before it reads
    asking.kill(SIGINT);
    status = asking.wait(std::chrono::seconds{1});
  }
  EXPECT_EQ(status, 130);
  EXPECT_THAT(asking.output(), AllOf(HasSubstr(calibrate::messages::kStopped),
                                     testing::Not(HasSubstr(calibrate::messages::kNoJointRead))));
}

TEST_F(CommandLine, DoctorRefusesARobotWithoutAPort) {
  EXPECT_EQ(call("doctor --robot virtual").status, 2);
}

TEST_F(CommandLine, AWindowThatCannotBeOpenedEndsWithStatus2) {
  const Outcome refused = call("window --robot /dev/ttyUSB0");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, HasSubstr("darwinop runtime --robot /dev/ttyUSB0"));
}

TEST_F(CommandLine, AWindowSaysThatItsControllerOrRuntimeIsNotThere) {
  const Outcome refused = call("window nothere");
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.said, std::string{"darwinop window: "} + runtime::messages::kNoSuchController + "nothere\n");
  Program window{{program("darwinop-window"), "--robot", "runtime"}, file("window.txt")};
  EXPECT_TRUE(window.says(window::messages::kNoRuntimeYet, std::chrono::seconds{10}));
}

TEST_F(CommandLine, AWrongArgumentIsReportedWithTheCommandThatExplainsIt) {
  EXPECT_THAT(call("motion play own 9 --peroid 8").said, HasSubstr("darwinop motion play --help"));
}

TEST_F(CommandLine, ThePreviewOfAMotionCountsFirstValuesInLaterPoses) {
  std::ofstream{file("late.motion")} << "#WEBOTS_MOTION,V1.0,Neck,ShoulderL\n00:00:000,A,0,*\n00:01:000,B,0,-1\n";
  const Outcome asked = call("motion play late.motion --robot /dev/null");
  EXPECT_NE(asked.status, 0) << "it needs --yes";
  EXPECT_THAT(asked.said, AllOf(HasSubstr("(ShoulderL)"), HasSubstr(motion::kLeadIn)));
}

TEST_F(CommandLine, OnlyMotionPlayReadsADotMotionFile) {
  std::ofstream{file("wave.motion")} << "#WEBOTS_MOTION,V1.0,Neck\n00:00:000,A,0\n";
  for (const char* command : {"list wave.motion", "show wave.motion 1", "check wave.motion"}) {
    const Outcome refused = call(std::string{"motion "} + command);
    EXPECT_EQ(refused.status, 2) << command;
    EXPECT_THAT(refused.said, HasSubstr(std::string{"wave.motion"} + motion::kOnlyPlayReads)) << command;
  }
}

TEST_F(CommandLine, EveryGapCommandHasAnExampleOfItself) {
  for (const std::string name : {"check", "locate", "run", "report", "add", "case", "record", "plan", "export"}) {
    const std::string command = "gap " + name;
    EXPECT_THAT(call(command + " --help").said, HasSubstr("\n  darwinop " + command + " ")) << name;
  }
}

TEST_F(CommandLine, RunNamesAnOptionThatItDoesNotHave) {
  const Outcome refused = call("run --robt virtual controller");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, HasSubstr("option --robt;"));
}

TEST_F(CommandLine, AVirtualRobotKeepsItsLink) {
  startVirtualRobot();
  const std::filesystem::path terminal = std::filesystem::read_symlink(port());
  const Outcome second = call("virtual-robot --for 0.1 --link " + port());
  EXPECT_EQ(second.status, 1);
  EXPECT_THAT(second.said, HasSubstr(port() + hil::kLinkTaken + std::to_string(virtual_robot_->pid()) + ";"));
  EXPECT_EQ(std::filesystem::read_symlink(port()), terminal);
  virtual_robot_.reset();  // killed: its link stays
  EXPECT_EQ(call("virtual-robot --for 0.1 --link " + port()).status, 0);
}

TEST_F(CommandLine, NeitherRecordingsNorCasesAreReplaced) {
  std::ofstream{file("keep.csv")} << "kept";
  for (const char* command : {"experiment run chirp", "motion play own 9", "run " DARWINOP_EXAMPLES "/01_hello_head"}) {
    const Outcome refused = call(command + std::string{" --robot virtual --record keep.csv"});
    EXPECT_EQ(refused.status, 2) << command;
    EXPECT_THAT(refused.said, HasSubstr(std::string{"keep.csv"} + runtime::messages::kRecordingExists));
    EXPECT_EQ(textOf(file("keep.csv")), "kept");
  }
  std::filesystem::create_directory(file("mine"));
  std::ofstream{file("mine/case.json")} << "kept";
  const Outcome refused = call("gap case keep.csv --out mine");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, HasSubstr("mine/case.json exists"));
}

TEST_F(CommandLine, GapRefusesBeforeItComputesOrAsks) {
  std::filesystem::create_directory(file("mine"));
  std::ofstream{file("mine/case.json")} << "{}";
  EXPECT_THAT(call("gap run mine --declare kp=3").said, HasSubstr("mine has a case.json"));
  EXPECT_THAT(call("gap run mine --out none/x.ini").said, HasSubstr("cannot write none/x.ini"));
  const Outcome refused = call("gap record --robot /dev/ttyNOTHING --yes --out new");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.said, testing::StartsWith("darwinop gap: port /dev/ttyNOTHING"));
  EXPECT_FALSE(std::filesystem::exists(file("new")));
}

}  // namespace
}  // namespace darwinop
