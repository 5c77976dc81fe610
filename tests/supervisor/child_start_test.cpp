#include "supervisor/child_start.hpp"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "hal/process/child_process.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::supervisor {
namespace {

using process::ChildProcess;
using process::Ending;
using process::Start;
using testing::AllOf;
using testing::HasSubstr;

template <class Condition>
bool soon(Condition condition) {
  for (int i = 0; i < 1000; ++i, std::this_thread::sleep_for(std::chrono::milliseconds{5}))
    if (condition()) return true;
  return false;
}

Ending endOf(ChildProcess& child) {
  EXPECT_TRUE(soon([&] { return child.ended().has_value(); }));
  return child.ended().value_or(Ending{-1, true});
}

Start shell(const std::string& script, const std::string& log = "") {
  return childStart({"/bin/sh", "-c", script}, log);
}

TEST(ChildOfTheSupervisor, ReportsExitCodeAndSignal) {
  ChildProcess failed{shell("exit 3")};
  const Ending code = endOf(failed);
  EXPECT_FALSE(code.by_signal);
  EXPECT_EQ(code.code, 3);
  ChildProcess killed{shell("kill -SEGV $$")};
  const Ending signal = endOf(killed);
  EXPECT_TRUE(signal.by_signal);
  EXPECT_EQ(signal.code, SIGSEGV);
}

TEST(ChildOfTheSupervisor, AppendsItsOutputAndHasItsFolderAndEnvironment) {
  const TemporaryFolder folder;
  std::ofstream{folder / "log"} << "before\n";
  setenv("SUPERVISOR_TEST", "old", 1);
  Start start = shell("pwd; echo $SUPERVISOR_TEST >&2", folder / "log");
  start.folder = "/";
  start.environment = {"SUPERVISOR_TEST=new"};
  ChildProcess child{start};
  EXPECT_TRUE(endOf(child).isNormal());
  EXPECT_EQ(textOf(folder / "log"), "before\n/\nnew\n");
}

TEST(ChildOfTheSupervisor, AMissingProgramEndsWithCode127AndAMessage) {
  const TemporaryFolder folder;
  ChildProcess child{childStart({folder / "nothing"}, folder / "log")};
  EXPECT_EQ(endOf(child).code, 127);
  EXPECT_THAT(textOf(folder / "log"), AllOf(HasSubstr("supervisor: "), HasSubstr(" " + (folder / "nothing: "))));
}

process::Account nobody() {
  return {"nobody", "/nonexistent", 65534, 65534, {65534, 44}};
}

TEST(ChildOfTheSupervisor, HasTheRightsOfAnAccountAndAppendsToALogThatItMayNotOpen) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can start a program as another user";
  const TemporaryFolder folder;
  std::ofstream{folder / "log"} << "before\n";
  std::filesystem::permissions(folder / "log", std::filesystem::perms::owner_read);
  Start start = shell("id -u; id -G; echo $HOME $USER; cat /etc/shadow 2>/dev/null || echo no shadow", folder / "log");
  start.account = nobody();
  ChildProcess child{start};
  EXPECT_TRUE(endOf(child).isNormal());
  EXPECT_EQ(textOf(folder / "log"), "before\n65534\n65534 44\n/nonexistent nobody\nno shadow\n");
}

TEST(ChildOfTheSupervisor, RunsInAGroupOfItsOwnWithNoSignalBlocked) {
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, &before);
  ChildProcess child{shell("exec sleep 100")};
  sigprocmask(SIG_SETMASK, &before, nullptr);
  EXPECT_TRUE(soon([&] { return getpgid(child.pid()) == child.pid(); }));
  child.signal(SIGTERM);
  const Ending ending = endOf(child);
  EXPECT_TRUE(ending.by_signal);
  EXPECT_EQ(ending.code, SIGTERM);
}

TEST(ChildOfTheSupervisor, GetsSigtermInsteadOfSigkillWhenItsHandleIsDestroyed) {
  const TemporaryFolder folder;
  {
    const ChildProcess child{
        shell("trap 'echo term; exit 0' TERM; echo up; while :; do sleep 0.01; done", folder / "log")};
    EXPECT_TRUE(soon([&] { return textOf(folder / "log") == "up\n"; }));
  }
  EXPECT_TRUE(soon([&] { return textOf(folder / "log") == "up\nterm\n"; }));
}

class OrphanedChild : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(AsTheSupervisorOrAsAnotherUser, OrphanedChild, testing::Bool());

TEST_P(OrphanedChild, GetsSigtermWhenItsParentIsKilled) {
  if (GetParam() && geteuid() != 0) GTEST_SKIP() << "only root can start a program as another user";
  const TemporaryFolder folder;
  const pid_t parent = fork();
  if (parent == 0) {
    Start start = shell("trap 'echo term; exit 0' TERM; echo up; while :; do sleep 0.01; done", folder / "log");
    if (GetParam()) start.account = nobody();
    const ChildProcess child{start};
    for (;;) pause();
  }
  EXPECT_TRUE(soon([&] { return textOf(folder / "log") == "up\n"; }));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_TRUE(soon([&] { return textOf(folder / "log") == "up\nterm\n"; }));
}

}  // namespace
}  // namespace darwinop::supervisor
