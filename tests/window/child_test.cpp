// Child processes of the window: environment, signals, end.
#include "window/child.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <thread>

#include "support/temporary_folder.hpp"

namespace darwinop {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;
using window::Child;
using Stdio = Child::Stdio;

struct WindowChild : testing::Test {
  void programIs(const std::string& text) {
    std::ofstream{program} << "#!/bin/sh\n" << text;
    chmod(program.c_str(), 0700);
  }
  std::unique_ptr<Child> start(Stdio stdio, std::chrono::milliseconds grace = 20s, char* variable = nullptr) {
    return std::make_unique<Child>("test", program, std::vector<std::string>{}, grace, stdio, variable);
  }
  template <class Done>
  static bool comes(Done done) {
    const auto end = std::chrono::steady_clock::now() + 20s;
    while (!done() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(1ms);
    return done();
  }
  static int statusOf(Child& child) {
    return comes([&] { return child.ended().has_value(); }) ? *child.ended() : -1;
  }
  /// Scripts write their files atomically: echo … >tmp; mv tmp FILE.
  std::string untilWritten(const std::string& name) {
    EXPECT_TRUE(comes([&] { return access((folder / name).c_str(), F_OK) == 0; })) << name;
    std::ifstream in{folder / name};
    return {std::istreambuf_iterator<char>{in}, {}};
  }
  std::string writes(const std::string& command, const std::string& name) const {
    return "{ " + command + "; } >" + (folder / "tmp-") + name + "; mv " + (folder / "tmp-") + name + " " +
           (folder / name) + "\n";
  }

  TemporaryFolder folder;
  std::string program = folder / "program";
};

constexpr const char* kForEver = "while :; do sleep 0.01; done\n";

TEST_F(WindowChild, ACapturedChildGetsSigintAndTheOthersSigterm) {
  for (const Stdio stdio : {Stdio::kCaptured, Stdio::kBackground, Stdio::kTerminal}) {
    const std::string name = "asked" + std::to_string(static_cast<int>(stdio));
    programIs("trap '" + writes("echo INT", name) + "exit' INT; trap '" + writes("echo TERM", name) + "exit' TERM\n" +
              writes("echo", "ready" + name) + kForEver);
    const auto child = start(stdio);
    (void)untilWritten("ready" + name);
  }  // ends the child and waits for it
  EXPECT_EQ(untilWritten("asked2"), "INT\n");
  EXPECT_EQ(untilWritten("asked0"), "TERM\n");
  EXPECT_EQ(untilWritten("asked1"), "TERM\n");
}

// The installer's ssh ends the programs on the robot; it must not be killed while it does.
TEST_F(WindowChild, KillsOnlyTheChildItselfWhileItsGroupCleansUp) {
  programIs("trap '' INT\nleader=$$\n{ while kill -0 $leader; do sleep 0.01; done; " + writes("echo", "tidied") +
            "} 2>/dev/null &\n" + writes("echo $$", "ready") + kForEver);
  auto child = start(Stdio::kCaptured, 1ms);
  const pid_t leader = std::stoi(untilWritten("ready"));
  EXPECT_FALSE(child->ended());
  child.reset();
  EXPECT_EQ(kill(leader, 0), -1) << "it still runs";
  EXPECT_TRUE(comes([&] { return access((folder / "tidied").c_str(), F_OK) == 0; }));
}

TEST_F(WindowChild, NoSignalIsBlockedInTheChildAndOurMaskIsRestored) {
  sigset_t some, before, after;
  sigemptyset(&some);
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) sigaddset(&some, signal);
  pthread_sigmask(SIG_BLOCK, &some, &before);
  const std::vector<std::string> words{"/proc/self/status", folder / "status"};
  for (const Stdio stdio : {Stdio::kCaptured, Stdio::kBackground, Stdio::kTerminal}) {
    Child child{"test", "/bin/cp", words, 20s, stdio, nullptr};  // a shell would unblock them
    EXPECT_EQ(statusOf(child), 0);
    EXPECT_THAT(untilWritten("status"), HasSubstr("SigBlk:\t0000000000000000\n"));
    unlink((folder / "status").c_str());
  }
  pthread_sigmask(SIG_SETMASK, &before, &after);
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1, SIGHUP})
    EXPECT_EQ(sigismember(&after, signal), sigismember(&some, signal)) << signal;
}

// Between fork and exec the child has our handlers, which would swallow a Ctrl-C.
TEST_F(WindowChild, ACtrlCJustAfterTheStartIsNotLost) {
  programIs(kForEver);
  for (const sighandler_t ours :
       {sighandler_t{[](int) {}}, SIG_IGN}) {  // the window's own handler; ignored, as under nohup
    const sighandler_t before = std::signal(SIGINT, ours);
    for (int i = 0; i < 20; ++i) {
      const auto child = start(Stdio::kCaptured);
      child->interrupt();
      ASSERT_EQ(statusOf(*child), 128 + SIGINT);
    }
    std::signal(SIGINT, before);
  }
}

TEST_F(WindowChild, APasswordReachesOnlyTheChildThatGetsOne) {
  setenv("DARWINOP_PASSWORD", "ours", 1);  // of the window's own login
  setenv("DARWINOP_PASSWORDLESS", "kept", 1);
  programIs(writes("env", "environment"));
  const auto environment = [this](Stdio stdio, char* variable) {
    const auto child = start(stdio, 20s, variable);
    std::string text = untilWritten("environment");
    unlink((folder / "environment").c_str());
    return text;
  };
  for (const Stdio stdio : {Stdio::kCaptured, Stdio::kBackground, Stdio::kTerminal}) {
    const std::string without = environment(stdio, nullptr);
    EXPECT_THAT(without, Not(HasSubstr("DARWINOP_PASSWORD=")));
    EXPECT_THAT(without, HasSubstr("DARWINOP_PASSWORDLESS=kept"));
    EXPECT_THAT(without, HasSubstr("PATH="));
  }
  std::string theirs = "DARWINOP_PASSWORD=theirs";
  const std::string with = environment(Stdio::kCaptured, theirs.data());
  EXPECT_THAT(with, HasSubstr("DARWINOP_PASSWORD=theirs\n"));
  EXPECT_THAT(with, Not(HasSubstr("ours")));
  unsetenv("DARWINOP_PASSWORD");
  unsetenv("DARWINOP_PASSWORDLESS");
}

}  // namespace
}  // namespace darwinop
