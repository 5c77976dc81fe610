// What a child process is started with: program, name, variables, user, priority, files.
#include "hal/process/start.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sched.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "hal/process/child_process.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::process {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Standard output or error of a child that ends.
std::string textOn(std::size_t number, Start start) {
  start.streams.resize(3);
  start.streams[number] = Stream::pipe();
  ChildProcess child{start};
  std::string text;
  for (char byte = 0; read(child.stream(number), &byte, 1) == 1;) text += byte;
  child.wait();
  return text;
}

/// Runs `what` in a process of its own, which it may change; false: an expectation of it has failed.
template <class What>
bool holdsInAnotherProcess(What what) {
  const pid_t test = fork();
  if (test == 0) {
    what();
    _exit(testing::Test::HasFailure() ? 1 : 0);
  }
  int status = -1;
  return waitpid(test, &status, 0) == test && status == 0;
}

TEST(FindProgram, SearchesTheFoldersOfPathForAnExecutable) {
  EXPECT_TRUE(holdsInAnotherProcess([] {
    const TemporaryFolder folder;
    std::ofstream{folder / "sh"} << "not executable";
    std::ofstream{folder / "here"} << "#!/bin/sh\n";
    chmod((folder / "here").c_str(), 0755);
    setenv("PATH", (folder / ".:/bin").c_str(), 1);
    EXPECT_EQ(findProgram("sh"), "/bin/sh");
    EXPECT_EQ(findProgram("here"), folder / "./here");
    setenv("PATH", "::/bin", 1);
    std::filesystem::current_path(folder / "");
    EXPECT_EQ(findProgram("here"), "./here") << "an empty word is the working directory";
    unsetenv("PATH");
    EXPECT_EQ(findProgram("sh"), "/bin/sh");
  }));
}

TEST(ProgramBeside, IsInTheFolderOfThisProgram) {
  const std::string ours = std::filesystem::read_symlink("/proc/self/exe");
  EXPECT_EQ(programBeside(std::filesystem::path{ours}.filename()), ours);
}

TEST(Start, TheNameIsTheFirstWordThatTheProgramSees) {
  Start start{.command = {"/bin/sh", "-c", "ps -o args= -p $$ || cat /proc/$$/cmdline"}};
  EXPECT_THAT(textOn(1, start), HasSubstr("/bin/sh"));
  start.name = "another-name";
  EXPECT_THAT(textOn(1, start), HasSubstr("another-name"));
}

TEST(Start, AVariableReplacesOnlyOneOfTheSameName) {
  setenv("PROCESS_TEST", "short", 1);
  setenv("PROCESS_TEST_LONGEST", "long", 1);
  const std::string all = textOn(1, {.command = {"env"}, .environment = {"PROCESS_TEST_LONG=new"}});
  for (const char* line : {"PROCESS_TEST=short\n", "PROCESS_TEST_LONG=new\n", "PROCESS_TEST_LONGEST=long\n"})
    EXPECT_THAT(all, HasSubstr(line));
}

TEST(Start, AProgramThatCannotGetIntoItsFolderDoesNotRun) {
  const std::string error =
      textOn(2, {.command = {"/bin/sh", "-c", "echo runs >&2"}, .folder = "/nonexistent", .error_prefix = "test: "});
  EXPECT_THAT(error,
              AllOf(StartsWith("test: "), EndsWith(std::string{" /nonexistent: "} + std::strerror(ENOENT) + "\n")));
}

TEST(Start, ClosesOthersFromTheFirstBehindTheStandardOnes) {
  EXPECT_TRUE(holdsInAnotherProcess([] {
    dup2(0, 3);  // without O_CLOEXEC
    Start start{.command = {"/bin/sh", "-c", "[ -e /proc/$$/fd/3 ] && echo open || echo closed"}};
    EXPECT_EQ(textOn(1, start), "open\n");
    start.closes_others = true;
    EXPECT_EQ(textOn(1, start), "closed\n");
  }));
}

TEST(Start, AFailureIsReportedEvenIfItsPipeHasTheNumberOfAStream) {
  EXPECT_TRUE(holdsInAnotherProcess([] {
    close(0);  // so that the pipe of the failure is 0 and 3
    const Start start{.command = {"/nonexistent"}, .streams = {{}, {}, {}, Stream::nothing()}};
    EXPECT_THROW(ChildProcess{start}, std::system_error);
  }));
}

TEST(Start, ALogFileHasMode0644AndOneBehindALinkIsReported) {
  const TemporaryFolder folder;
  const mode_t before = umask(022);
  Start start{.command = {"true"}, .streams = {{}, Stream::appendedTo(folder / "log")}, .error_prefix = "test: "};
  EXPECT_EQ(textOn(2, start), "");
  umask(before);
  struct stat about {};
  ASSERT_EQ(stat((folder / "log").c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777U, 0644U);
  std::filesystem::create_symlink("log", folder / "link");
  start.streams = {{}, Stream::appendedTo(folder / "link")};
  testing::internal::CaptureStderr();
  EXPECT_TRUE(ChildProcess{start}.wait().isNormal()) << "it goes without a log";
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "test: cannot write to " + (folder / "link") + ": Too many levels of symbolic links\n");
}

TEST(Start, AnOrdinaryChildHasNeitherOurPriorityNorOurProtection) {
  EXPECT_TRUE(holdsInAnotherProcess([] {
    const sched_param none{};
    ASSERT_EQ(sched_setscheduler(0, SCHED_BATCH, &none), 0);  // stands for SCHED_FIFO, which needs rights
    std::ofstream{"/proc/self/oom_score_adj"} << 500;         // stands for a protection, for the same reason
    ASSERT_EQ(textOf("/proc/self/oom_score_adj"), "500\n");
    for (const bool ordinary : {false, true}) {
      ChildProcess child{{.command = {"/bin/sh", "-c", "cat /proc/$$/oom_score_adj; read line"},
                          .streams = {Stream::pipe(), Stream::pipe()},
                          .error_prefix = "",
                          .ordinary_priority = ordinary,
                          .expendable = ordinary}};
      char text[8] = {};
      EXPECT_GT(read(child.stream(1), text, sizeof text - 1), 0);
      EXPECT_STREQ(text, ordinary ? "0\n" : "500\n");
      EXPECT_EQ(sched_getscheduler(child.pid()), ordinary ? SCHED_OTHER : SCHED_BATCH);
    }
  }));
}

TEST(Start, AProgramOfAnotherUserHasItsRightsAndVariables) {
  const Account nobody{
      .name = "someone", .home = "/home/someone", .uid = 65534, .gid = 65534, .groups = {65534, 12345}};
  Start start{.command = {"/bin/sh", "-c", "id -u; id -g; id -G; echo $HOME $USER $LOGNAME"},
              .error_prefix = "test: ",
              .account = nobody};
  if (geteuid() == 0)
    EXPECT_EQ(textOn(1, start), "65534\n65534\n65534 12345\n/home/someone someone someone\n");
  else
    EXPECT_THAT(textOn(2, start), AllOf(StartsWith("test: "), HasSubstr(" someone: ")));
}

TEST(ChildProcess, TheNumberOfAClosedStreamIsGone) {
  ChildProcess child{{.command = {"cat"}, .streams = {Stream::pipe(), Stream::pipe()}}};
  const int ours = child.stream(1);
  EXPECT_EQ(child.stream(2), -1);
  child.closeStream(1);
  EXPECT_EQ(child.stream(1), -1);
  EXPECT_EQ(fcntl(ours, F_GETFD), -1) << "it is closed";
  ASSERT_EQ(dup2(0, ours), ours);
  child.closeStream(1);
  EXPECT_NE(fcntl(ours, F_GETFD), -1) << "and is not closed twice";
  close(ours);
  child.closeStream(0);
  child.wait();
}

TEST(ChildProcess, ClosesItsStreamsWithItsHandle) {
  int ours = -1;
  {
    ChildProcess child{{.command = {"true"}, .streams = {{}, Stream::pipe()}}};
    child.wait();
    ours = child.stream(1);
    EXPECT_NE(fcntl(ours, F_GETFD), -1);
  }
  EXPECT_EQ(fcntl(ours, F_GETFD), -1);
}

}  // namespace
}  // namespace darwinop::process
