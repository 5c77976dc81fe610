// `darwinop run`: exit status, signals, environment, and the report as the last line.
#include "runtime/controller_run.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "child.hpp"
#include "environment.hpp"
#include "fake_bus.hpp"
#include "runtime/daemon.hpp"
#include "runtime/messages.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::runtime {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

struct Outcome {
  int status;
  std::string said, warned, last_line;
};

Outcome run(const std::string& argument) {
  const Environment away{"DARWINOP_RUNTIME_NAME", "darwinop-test-none"};
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Outcome outcome;
  RunRequest request{{MINI_CONTROLLER, argument}, "virtual", "", "8"};
  request.hang_up = {std::chrono::milliseconds{20}, std::chrono::milliseconds{20}};
  outcome.status = runController(request);
  outcome.said = testing::internal::GetCapturedStdout();
  outcome.warned = testing::internal::GetCapturedStderr();
  const std::string text = outcome.said.substr(0, outcome.said.size() - 1);
  outcome.last_line = text.substr(text.rfind('\n') + 1);
  return outcome;
}

TEST(Run, PassesTheStatusOnAndEndsWithTheReportOfTheWholeRun) {
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.status, 7);
  EXPECT_THAT(outcome.said, HasSubstr("robot=virtual period=8\n"));
  EXPECT_THAT(outcome.last_line,
              ContainsRegex("^report: cycles=([2-9][0-9]|[1-9][0-9][0-9]) overruns=0 wake_p50_us=nan .* stale=0$"));
}

TEST(Run, ReportsAControllerThatWasKilled) {
  const Outcome outcome = run("die");
  EXPECT_EQ(outcome.status, 128 + SIGKILL);
  EXPECT_THAT(outcome.last_line, StartsWith("report: cycles=20 "));
  EXPECT_THAT(outcome.warned, testing::Not(HasSubstr("torque"))) << "a robot in simulated time has none to hold";
}

TEST(Run, SaysThatNoLoopIsLeftWhenTheControllerThatHadItIsKilledOrSkipsItsEnd) {
  for (const char* how : {"crash", "leave"}) {
    const Outcome outcome = run(how);
    EXPECT_THAT(outcome.warned, HasSubstr(messages::kNoLoopLeft)) << how;
    EXPECT_NE(outcome.status, 0) << "joints have torque, whatever the controller returned";
  }
}

TEST(Run, NamesAServoThatIsSilentAtTheEndForItMayBeStiff) {
  const Outcome outcome = run("unplug Neck");
  EXPECT_THAT(outcome.warned, HasSubstr(std::string{messages::kNoLoopLeft} + "Neck."));
  EXPECT_EQ(outcome.status, 1);
}

TEST(Run, ReportsNoJointAfterARobotWasBroughtToRest) {
  const Outcome outcome = run("rest");
  EXPECT_THAT(outcome.warned, testing::Not(HasSubstr(messages::kNoLoopLeft)));
  EXPECT_EQ(outcome.status, 0);
}

TEST(Run, HandsOnASignalThatAnotherProcessSends) {
  EXPECT_EQ(run("wait").status, 5);
}

TEST(Run, EndsAControllerThatOutlivesItsTerminalOnceTheRobotIsLimp) {
  const Outcome outcome = run("hang");
  EXPECT_EQ(outcome.status, 128 + SIGKILL);
  EXPECT_THAT(outcome.warned, testing::Not(HasSubstr(messages::kNoLoopLeft)));
}

TEST(Run, ReportsNothingRunForAProgramThatIsNotAController) {
  const Environment away{"DARWINOP_RUNTIME_NAME", "darwinop-test-none"};
  testing::internal::CaptureStdout();
  EXPECT_EQ(runController({{"/bin/false"}, "", "", ""}), 1);
  EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("\nreport: cycles=0 overruns=0 wake_p50_us=nan"));
}

TEST(Run, LeavesTheFiguresOfADaemonAloneThatItDidNotDrive) {
  const TemporaryFolder folder;
  const RuntimeFiles files{folder / "runtime"};
  const Child daemon{[&] {
    static Daemon serving{LoopConfig{}, files, claimRuntime(files, getgid()), getgid(), std::make_unique<FakeBus>()};
    usleep(50'000);
  }};
  const Environment there{"DARWINOP_RUNTIME_NAME", files.exchange};
  testing::internal::CaptureStdout();
  EXPECT_EQ(runController({{MINI_CONTROLLER, "away"}, "", "", ""}), 3);
  EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr(messages::kNoCycle));
}

TEST(Run, LeavesNoFileBehind) {
  run("die");
  for (const auto& entry : std::filesystem::directory_iterator{"/dev/shm"})
    EXPECT_THAT(entry.path().string(), testing::Not(HasSubstr("darwinop-run-" + std::to_string(getpid()))));
}

TEST(Run, SweepsUpAfterARunThatWasKilledItself) {
  const pid_t dead = fork();
  if (dead == 0) _exit(0);
  waitpid(dead, nullptr, 0);
  const std::string left = "/dev/shm/darwinop-run-" + std::to_string(dead);
  const std::string alive = "/dev/shm/darwinop-run-" + std::to_string(getppid()) + "-AbCdEf";
  std::ofstream{left} << "a file of earlier versions";
  for (const std::string& folder : {left + "-AbCdEf", alive}) {
    std::filesystem::create_directory(folder);
    std::ofstream{folder + "/exchange"} << "x";
  }
  run("");
  EXPECT_FALSE(std::filesystem::exists(left));
  EXPECT_FALSE(std::filesystem::exists(left + "-AbCdEf"));
  EXPECT_TRUE(std::filesystem::exists(alive + "/exchange"));
  std::filesystem::remove_all(alive);
}

/// The name consists of more than the pid, which another user can guess.
TEST(Run, WorksThoughAnotherUserTookTheNameWithItsPidBeforehand) {
  const std::string taken = "/dev/shm/darwinop-run-" + std::to_string(getpid());
  std::filesystem::create_directories(taken + "/full");  // even root cannot replace it by a file
  const Outcome outcome = run("");
  EXPECT_TRUE(std::filesystem::exists(taken + "/full"));
  std::filesystem::remove_all(taken);
  EXPECT_EQ(outcome.status, 7) << outcome.warned;
  EXPECT_THAT(outcome.last_line, ContainsRegex("^report: cycles=[1-9]"));
}

TEST(Run, TakesAFolderForTheProgramOfItsName) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "walk");
  std::filesystem::create_symlink("/bin/true", folder / "walk/walk");
  EXPECT_EQ(controllerProgram(folder / "walk"), folder / "walk/walk");
  EXPECT_EQ(controllerProgram(folder / "walk/"), folder / "walk/walk");
}

std::string refusal(const std::string& controller) {
  try {
    return "accepted " + controllerProgram(controller);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(Run, NamesTheScriptsOfAFolderWithoutAProgram) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "my folder");
  for (const char* name : {"nod.py", "my controller.py", "notes.txt"})
    std::ofstream{folder / ("my folder/" + std::string{name})};
  EXPECT_THAT(refusal(folder / "my folder"),
              testing::EndsWith(messages::kNameScript + (folder / "my folder/my controller.py") + ", " +
                                (folder / "my folder/nod.py")));
}

TEST(Run, SaysWhatItLookedFor) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "walk");
  EXPECT_EQ(refusal(folder / "none"), messages::kNoSuchController + (folder / "none"));
  EXPECT_THAT(refusal(folder / "walk"),
              AllOf(StartsWith(messages::kNoSuchController + (folder / "walk/walk")), HasSubstr("make")));
  std::filesystem::create_directory(folder / "walk/build");
  std::filesystem::create_symlink("/bin/true", folder / "walk/build/walk");
  EXPECT_THAT(refusal(folder / "walk"), testing::EndsWith(messages::kBuiltIn + (folder / "walk/build/walk")));
  std::filesystem::create_directories(folder / "controllers/nod");
  EXPECT_THAT(refusal(folder / "controllers/nod"), testing::EndsWith(messages::kBuildFirst));
  const std::string built = folder / "build/release/controllers/nod/nod";
  std::filesystem::create_directories(std::filesystem::path{built}.parent_path());
  std::filesystem::create_symlink("/bin/true", built);
  EXPECT_THAT(refusal(folder / "controllers/nod"), testing::EndsWith(messages::kBuiltIn + built));
  EXPECT_THAT(refusal("/etc/passwd"), StartsWith(std::string{"/etc/passwd"} + messages::kNotAProgram));
}

}  // namespace
}  // namespace darwinop::runtime
