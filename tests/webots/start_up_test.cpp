// Robot(): environment, config.ini, signals, and how it ends the program. The link is replaced at link time.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <webots/Motor.hpp>

#include "connect/camera.hpp"
#include "connect/connect.hpp"
#include "connect/keys.hpp"
#include "fixture.hpp"
#include "run_tool.hpp"
#include "support/temporary_folder.hpp"
#include "webots/messages.hpp"
#include "webots/stop_signals.hpp"
#include "webots/tool_robot.hpp"

namespace {
darwinop::webots_api::FakeRobot* robot_to_meet = nullptr;
darwinop::connect::ConnectRequest request_seen;
}  // namespace

namespace darwinop::connect {
std::unique_ptr<runtime::RobotLink> connect(const ConnectRequest& request) {
  request_seen = request;
  if (!robot_to_meet) throw std::runtime_error("no robot at " + request.setting + ": switch it on");
  return std::make_unique<webots_api::FakeLink>(*robot_to_meet);
}
std::unique_ptr<FrameSource> openCamera(runtime::RobotLink& /*robot*/, const CameraRequest& /*request*/) {
  return nullptr;
}
std::unique_ptr<KeySource> openKeys(KeysRequest /*request*/, const std::atomic<bool>& /*ending*/) {
  return nullptr;
}
}  // namespace darwinop::connect

namespace darwinop::webots_api {
namespace {

namespace fs = std::filesystem;

class StartUp : public testing::Test {
 protected:
  StartUp() {
    forgetWarnings();
    robot_to_meet = &fake_;
    for (const char* name : {"DARWINOP_ROBOT", "DARWINOP_PERIOD_MS", "DARWINOP_RECORD", "DARWINOP_KEEP_CWD"})
      unsetenv(name);
  }
  ~StartUp() override {
    fs::current_path(before_);
    fs::remove(programDirectory() + "/config.ini");
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_DFL);
  }
  static void writeConfig(const std::string& text) { std::ofstream{programDirectory() + "/config.ini"} << text; }

  FakeRobot fake_;
  const fs::path before_ = fs::current_path();
};
using StartUpDeathTest = StartUp;

TEST_F(StartUp, TheProgramWorksInItsOwnDirectory) {
  fs::current_path("/");
  const webots::Robot robot;
  EXPECT_EQ(fs::current_path(), programDirectory());
}

TEST_F(StartUp, TheWorkingDirectoryIsKeptOnRequest) {
  fs::current_path("/");
  setenv("DARWINOP_KEEP_CWD", "1", 1);
  const webots::Robot robot;
  EXPECT_EQ(fs::current_path(), "/");
}

TEST_F(StartUp, TheEnvironmentChoosesTheRobot) {
  setenv("DARWINOP_ROBOT", "/dev/ttyUSB7", 1);
  setenv("DARWINOP_PERIOD_MS", "8", 1);
  setenv("DARWINOP_RECORD", "/tmp/log.csv", 1);
  const webots::Robot robot;
  EXPECT_EQ(request_seen.setting, "/dev/ttyUSB7");
  EXPECT_EQ(request_seen.period, std::chrono::milliseconds{8});
  EXPECT_EQ(request_seen.safety.period, std::chrono::milliseconds{8});
  EXPECT_EQ(request_seen.record_path, "/tmp/log.csv");
}

TEST_F(StartUp, ConfigIniBesideTheProgramIsRead) {
  fs::current_path("/");
  writeConfig("[Robot Config]\ntime_step=24\n[Safety]\nstall_ms=250\n");
  const webots::Robot robot;
  EXPECT_EQ(robot.getBasicTimeStep(), 24);
  EXPECT_EQ(request_seen.safety.stall_ms, 250);
}

TEST_F(StartUp, TheFolderOfAnInterpretedProgramTakesThePlaceOfTheInterpretersOwn) {
  const TemporaryFolder folder;
  const std::string scripts = fs::canonical(folder / ".").string();
  setProgramDirectory(scripts);
  writeConfig("[Robot Config]\ntime_step=24\n");
  {
    const webots::Robot robot;
    EXPECT_EQ(fs::current_path(), scripts);
    EXPECT_EQ(robot.getProjectPath(), scripts);
    EXPECT_EQ(robot.getBasicTimeStep(), 24);
  }
  fs::current_path(before_);
  setProgramDirectory("");
  EXPECT_NE(programDirectory(), scripts);
}

TEST_F(StartUp, AFailedStartCanBeCaught) {
  robot_to_meet = nullptr;
  EXPECT_THROW(connectOrThrow(), std::runtime_error);
  robot_to_meet = &fake_;
  const webots::Robot robot;
  EXPECT_THROW(connectOrThrow(), std::runtime_error) << "there is one already";
}

TEST_F(StartUp, AToolNeedsNoConfigIniButReadsOneThatIsThere) {
  testing::internal::CaptureStderr();
  { const ToolRobot robot; }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  writeConfig("[Safety]\nstall_ms=250\n");
  { const ToolRobot robot; }
  EXPECT_EQ(request_seen.safety.stall_ms, 250);
}

TEST_F(StartUp, OnlyAToolMayStateThatTheTrunkIsHeldAndMeansASmallGain) {
  testing::internal::CaptureStderr();
  {
    ToolRobot robot{{.trunk_is_held = true}};
    robot.getMotor("Neck")->setControlPID(1, 0, 0);
    EXPECT_EQ(robot.step(16), 0);
  }
  EXPECT_TRUE(request_seen.trunk_is_held);
  EXPECT_EQ(fake_.last().joint[index(Joint::kNeck)].p_gain, 1) << "it counts";
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  const webots::Robot robot;
  EXPECT_FALSE(request_seen.trunk_is_held);
}

/// Exit code of a program that makes a robot.
int codeOfTool() {
  return app::runTool("darwinop tool", [] {
    const ToolRobot robot;
    return app::kDone;
  });
}

TEST_F(StartUp, TheExitCodeOfAToolSaysWhetherTheRobotMayHaveMoved) {
  EXPECT_EQ(codeOfTool(), app::kDone);
  robot_to_meet = nullptr;
  EXPECT_EQ(codeOfTool(), app::kWrong);
  robot_to_meet = &fake_;
  fake_.image.safety.controller_must_end = true;
  EXPECT_EQ(codeOfTool(), app::kFailed);
}

TEST_F(StartUp, CtrlCBeforeTheRobotIsReadyEndsAToolAsStopped) {
  fake_.during_wait = [] { std::raise(SIGINT); };
  EXPECT_EQ(codeOfTool(), app::kStopped);
}

TEST_F(StartUp, CtrlCMakesStepReturnMinusOne) {
  webots::Robot robot;
  EXPECT_EQ(robot.step(16), 0);
  fake_.during_wait = [] { std::raise(SIGINT); };
  EXPECT_EQ(robot.step(16), -1);
}

// Sent to a process group, a signal comes by itself and once more from who started the controller.
TEST_F(StartUp, ASignalThatComesTwiceAtOnceIsOneRequest) {
  webots::Robot robot;
  std::raise(SIGINT);
  std::raise(SIGINT);
  EXPECT_EQ(robot.step(16), -1);
}

TEST_F(StartUp, ASecondCtrlCEndsTheController) {
  webots::Robot robot;
  std::raise(SIGINT);
  EXPECT_EXIT(
      {
        std::this_thread::sleep_for(std::chrono::milliseconds{350});
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

TEST_F(StartUp, SigtermMakesStepReturnMinusOne) {
  webots::Robot robot;
  std::raise(SIGTERM);
  EXPECT_EQ(robot.step(16), -1);
}

TEST_F(StartUp, ATerminalThatGoesAwayMakesStepReturnMinusOneHoweverOftenItSaysSo) {
  webots::Robot robot;
  std::raise(SIGHUP);
  std::raise(SIGHUP);
  EXPECT_EQ(robot.step(16), -1);
}

TEST_F(StartUp, APipeThatNobodyReadsDoesNotEndTheController) {
  webots::Robot robot;
  std::raise(SIGPIPE);
  EXPECT_EQ(robot.step(16), 0);
}

TEST_F(StartUp, AHandlerThatTheControllerHasForPipesStays) {
  static int caught = 0;
  std::signal(SIGPIPE, [](int) { ++caught; });
  webots::Robot robot;
  std::raise(SIGPIPE);
  EXPECT_EQ(caught, 1);
}

TEST_F(StartUp, ASignalThatTheParentIgnoresStaysIgnored) {
  std::signal(SIGINT, SIG_IGN);
  webots::Robot robot;
  std::raise(SIGINT);
  EXPECT_EQ(robot.step(16), 0);
}

TEST_F(StartUpDeathTest, NoRobotIsASentenceAndStatusOne) {
  robot_to_meet = nullptr;
  setenv("DARWINOP_ROBOT", "/dev/ttyUSB0", 1);
  EXPECT_EXIT(webots::Robot{}, testing::ExitedWithCode(1), "darwinop: no robot at /dev/ttyUSB0: switch it on");
}

TEST_F(StartUpDeathTest, AFaultAtTheStartIsASentenceAndStatusOne) {
  fake_.image.safety.controller_must_end = true;
  fake_.image.safety.worst = Fault::kBatteryEmpty;
  EXPECT_EXIT(webots::Robot{}, testing::ExitedWithCode(1),
              testing::HasSubstr("darwinop: " + std::string{row(Fault::kBatteryEmpty).meaning}));
}

TEST_F(StartUpDeathTest, ABadConfigIsASentenceAndStatusOne) {
  writeConfig("[Robot Config]\ntime_step=never\n");
  EXPECT_EXIT(webots::Robot{}, testing::ExitedWithCode(1), "config.ini, line 2: time_step = never");
}

TEST_F(StartUpDeathTest, ABadPeriodIsASentenceAndStatusOne) {
  setenv("DARWINOP_PERIOD_MS", "sixteen", 1);
  EXPECT_EXIT(webots::Robot{}, testing::ExitedWithCode(1), "DARWINOP_PERIOD_MS = sixteen");
}

TEST_F(StartUpDeathTest, ASecondRobotIsASentenceAndStatusOne) {
  const webots::Robot first;
  EXPECT_EXIT(webots::Robot{}, testing::ExitedWithCode(1), testing::HasSubstr(webots_api::messages::kSecondRobot));
}

void failUncaught() {
  throw std::runtime_error("a mistake");
}

/// At the end of the program or when std::terminate() has been called.
void printEndOfSession() {
  std::fputs(robot_to_meet->end_of_session ? "the session was ended\n" : "the session was not ended\n", stderr);
}
struct PrintAtExit {
  ~PrintAtExit() { printEndOfSession(); }
};

TEST_F(StartUpDeathTest, ExitEndsTheSessionOfARobotThatNobodyDeletes) {
  EXPECT_EXIT(
      {
        static const PrintAtExit at_exit;
        new webots::Robot;
        std::exit(0);
      },
      testing::ExitedWithCode(0), "the session was ended");
}

TEST_F(StartUpDeathTest, AChildThatTheControllerForksDoesNotEndItsSession) {
  EXPECT_EXIT(
      {
        static const PrintAtExit at_exit;
        new webots::Robot;
        if (fork() == 0) std::exit(0);
        wait(nullptr);
        _exit(0);
      },
      testing::ExitedWithCode(0), "the session was not ended");
}

TEST_F(StartUpDeathTest, AnUncaughtExceptionEndsTheSessionBeforeTheUsualEnd) {
  EXPECT_EXIT(
      {
        std::set_terminate(printEndOfSession);
        { const webots::Robot before; }
        fake_.end_of_session = false;
        new webots::Robot;
        []() noexcept { failUncaught(); }();
      },
      testing::KilledBySignal(SIGABRT), "the session was ended");
}

TEST_F(StartUpDeathTest, AnUncaughtExceptionOfAnotherThreadLeavesTheLinkAlone) {
  EXPECT_EXIT(
      {
        std::set_terminate(printEndOfSession);
        new webots::Robot;
        std::thread{failUncaught}.join();
      },
      testing::KilledBySignal(SIGABRT), "the session was not ended");
}

}  // namespace
}  // namespace darwinop::webots_api
