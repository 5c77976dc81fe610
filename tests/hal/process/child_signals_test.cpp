// Signals of child processes: what they inherit, their group, the end of their parent.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "hal/process/child_process.hpp"
#include "hal/signals.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::process {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

/// /proc/self/status of a program that was started so, with both kinds of start.
std::string statusWith(Start start, const TemporaryFolder& folder, bool forked) {
  start.command = {"/bin/cp", "/proc/self/status", folder / "status"};  // a shell would change them
  if (forked) start.error_prefix = "";
  ChildProcess child{start};
  EXPECT_TRUE(child.wait().isNormal());
  return textOf(folder / "status");
}

struct ChildSignals : testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(BesideUsOrForked, ChildSignals, testing::Bool());

TEST_P(ChildSignals, AreNeitherBlockedNorIgnoredAndOurMaskIsRestored) {
  const pid_t test = fork();
  if (test == 0) {
    ignoreSignals();
    signal(SIGHUP, SIG_IGN);  // as under nohup
    sigset_t some, after;
    sigemptyset(&some);
    sigaddset(&some, SIGUSR1);
    sigaddset(&some, SIGTERM);
    sigprocmask(SIG_BLOCK, &some, nullptr);
    const TemporaryFolder folder;
    const std::string all = statusWith({.command = {}}, folder, GetParam());
    const std::string kept = statusWith({.command = {}, .keeps_ignored_signals = true}, folder, GetParam());
    EXPECT_THAT(all, HasSubstr("SigBlk:\t0000000000000000\n"));
    EXPECT_THAT(all, HasSubstr("SigIgn:\t0000000000000000\n"));
    EXPECT_THAT(kept, HasSubstr("SigIgn:\t0000000000000001\n"));
    sigprocmask(SIG_SETMASK, nullptr, &after);
    for (const int number : {SIGINT, SIGTERM, SIGUSR1, SIGHUP})
      EXPECT_EQ(sigismember(&after, number), sigismember(&some, number)) << number;
    _exit(testing::Test::HasFailure() ? 1 : 0);
  }
  int status = 0;
  waitpid(test, &status, 0);
  EXPECT_EQ(status, 0);
}

// Between fork and exec a child has our handlers, which would swallow a Ctrl-C.
TEST_P(ChildSignals, JustAfterTheStartAreNotLost) {
  for (const sighandler_t ours : {sighandler_t{[](int) {}}, SIG_IGN}) {
    const sighandler_t before = std::signal(SIGINT, ours);
    for (int i = 0; i < 20; ++i) {
      Start start{.command = {"/bin/sleep", "100"}, .group = Start::Group::kItsOwnSession};
      start.keeps_ignored_signals = i % 2 == 0 && ours != SIG_IGN;
      if (GetParam()) start.error_prefix = "";
      ChildProcess child{start};
      child.signalGroup(SIGINT);
      ASSERT_EQ(child.wait().shellStatus(), 128 + SIGINT);
    }
    std::signal(SIGINT, before);
  }
}

TEST(ChildGroup, IsOursItsOwnOrASessionOfItsOwn) {
  const ChildProcess ours{{.command = {"/bin/sleep", "100"}}};
  const ChildProcess own{{.command = {"/bin/sleep", "100"}, .group = Start::Group::kItsOwn}};
  const ChildProcess session{{.command = {"/bin/sleep", "100"}, .group = Start::Group::kItsOwnSession}};
  EXPECT_EQ(getpgid(ours.pid()), getpgid(0));
  EXPECT_EQ(getpgid(own.pid()), own.pid());
  EXPECT_EQ(getsid(own.pid()), getsid(0));
  EXPECT_EQ(getsid(session.pid()), session.pid());
}

TEST(ChildGroup, GetsASignalTogether) {
  ChildProcess child{{.command = {"/bin/sh", "-c", "sleep 100 & echo $!; wait"},
                      .streams = {{}, Stream::pipe()},
                      .group = Start::Group::kItsOwnSession}};
  char text[16] = {};
  ASSERT_GT(read(child.stream(1), text, sizeof text - 1), 1);
  child.signalGroup(SIGTERM);
  EXPECT_EQ(child.wait().code, SIGTERM);
  char byte = 0;
  EXPECT_EQ(read(child.stream(1), &byte, 1), 0) << "process " << text << " still has the pipe";
}

struct Orphan : testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(BesideUsOrForked, Orphan, testing::Bool());

TEST_P(Orphan, GetsSigtermWhenItsParentIsKilled) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t parent = fork();
  if (parent == 0) {
    Start start{.command = {"/bin/sh", "-c", "trap 'echo term; exit' TERM; echo up; while :; do sleep 0.01; done"},
                .streams = {{}, Stream::copyOf(ends[1])},
                .closes_others = true,
                .ends_with_us = true};
    if (GetParam()) start.error_prefix = "";
    const ChildProcess child{start};
    for (;;) pause();
  }
  close(ends[1]);
  char text[16] = {};
  EXPECT_EQ(read(ends[0], text, 3), 3);
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_EQ(read(ends[0], text, 5), 5);
  EXPECT_STREQ(text, "term\n");
  close(ends[0]);
}

TEST(ChildProcess, GetsSigtermAndNotSigkillWhenItsHandleIsDestroyed) {
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  {
    const ChildProcess child{
        {.command = {"/bin/sh", "-c", "trap 'echo term; exit' TERM; echo up; while :; do sleep 0.01; done"},
         .streams = {{}, Stream::copyOf(ends[1])}}};
    close(ends[1]);
    char text[3];
    EXPECT_EQ(read(ends[0], text, 3), 3);
  }
  char text[16] = {};
  EXPECT_EQ(read(ends[0], text, 5), 5);
  EXPECT_STREQ(text, "term\n");
  close(ends[0]);
  EXPECT_GT(waitpid(-1, nullptr, 0), 0);
}

}  // namespace
}  // namespace darwinop::process
