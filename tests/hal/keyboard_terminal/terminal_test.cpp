// Terminal keyboard in a process of its own on a real pty; restoring the terminal.
#include <gmock/gmock.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "connect/keys.hpp"
#include "hal/keyboard_terminal/key_report.hpp"
#include "hal/keyboard_terminal/raw_mode.hpp"
#include "hal/keyboard_x11/display.hpp"

namespace darwinop::connect {
namespace {

using testing::HasSubstr;

std::atomic<bool> end_requested{false};

void onInterrupt(int) {
  end_requested = true;
}

/// Stand-in controller: polls every few ms and prints changes. Q ends it normally, X by a crash.
[[noreturn]] void controller(const std::string& from) {
  prctl(PR_SET_DUMPABLE, 0L);
  static_cast<void>(std::setvbuf(stdout, nullptr, _IONBF, 0));
  signal(SIGINT, onInterrupt);
  const auto keys = openKeys(
      {.from = from, .display = "", .log = [](const std::string& what) { std::printf("said: %s\r\n", what.c_str()); }},
      end_requested);
  std::printf("listening\r\n");
  for (std::vector<Key> before; !end_requested;) {
    const std::vector<Key> now = keys->take();
    if (now != before) {
      std::printf("[");
      for (const Key key : now) std::printf(" %d", key);
      std::printf(" ]\r\n");
    }
    for (const Key key : now) {
      if (key == 'Q') std::exit(0);
      if (key == 'X') std::abort();
    }
    before = now;
    std::this_thread::sleep_for(std::chrono::milliseconds{2});
  }
  // The robot kneels; keys are no longer polled.
  if (from == "terminal") std::this_thread::sleep_for(std::chrono::minutes{1});
  std::_Exit(0);
}

class Terminal : public testing::Test {
 protected:
  void start(const std::string& from = "terminal") {
    std::fflush(stdout);
    // Signals of the terminal are blocked while a sanitizer begins its own thread in the child: that thread would take
    // them and keep them for ever.
    sigset_t of_terminal, kept;
    sigemptyset(&of_terminal);
    sigaddset(&of_terminal, SIGINT);
    sigaddset(&of_terminal, SIGQUIT);
    pthread_sigmask(SIG_BLOCK, &of_terminal, &kept);
    pid = forkpty(&master, nullptr, nullptr, nullptr);
    pthread_sigmask(SIG_SETMASK, &kept, nullptr);
    if (pid == 0) controller(from);
    ASSERT_GT(pid, 0);
  }
  ~Terminal() override {
    if (pid > 0) {
      kill(pid, SIGKILL);
      waitpid(pid, nullptr, 0);
    }
    close(master);
  }
  void type(const std::string& bytes) const {
    ASSERT_EQ(write(master, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  bool shows(const std::string& text) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{20};
    while (shown.find(text) == std::string::npos && std::chrono::steady_clock::now() < end) receive();
    return shown.find(text) != std::string::npos;
  }
  void receive() {
    pollfd ready{master, POLLIN, 0};
    std::array<char, 256> part{};
    if (poll(&ready, 1, 20) != 1) return;
    const ssize_t count = read(master, part.data(), part.size());
    if (count <= 0) return;
    shown.append(part.data(), static_cast<std::size_t>(count));
    reply();
  }
  /// The program has asked this many times.
  bool asks(int times) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{20};
    while (queries < times && std::chrono::steady_clock::now() < end) receive();
    return queries >= times;
  }
  /// As a terminal that can report keys. Queries may be in the middle of other output.
  void reply() {
    for (std::size_t query = 0; (query = shown.find(terminal::kAskForReports)) != std::string::npos;) {
      shown.erase(query, terminal::kAskForReports.size());
      ++queries;
      if (replies) type(shown.find(terminal::kStartReports) < query ? "\x1b[?15u" : "\x1b[?0u");
    }
  }
  /// True: line mode with echo, as before. False: raw mode.
  [[nodiscard]] bool isAsBefore() const {
    termios now{};
    tcgetattr(master, &now);
    return (now.c_lflag & (ICANON | ECHO)) == (ICANON | ECHO) && (now.c_iflag & ICRNL) != 0 && now.c_cc[VMIN] == 1;
  }
  bool becomesAsBefore() const {
    for (int i = 0; i < 2000 && !isAsBefore(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds{5});
    return isAsBefore();
  }
  int ending() {
    int status = 0;
    waitpid(pid, &status, 0);
    pid = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  pid_t pid = 0;
  int master = -1;
  std::string shown;
  bool replies = false;  // to kAskForReports
  int queries = 0;
};

TEST_F(Terminal, ReadsArrowsAndLettersAndRestoresTheTerminal) {
  start("");
  ASSERT_TRUE(shows(std::string{"("} + x11::kDisplayNotSet + "): " + kKeysFromTerminal)) << shown;
  EXPECT_FALSE(isAsBefore());
  type("\x1b[A");
  EXPECT_TRUE(shows("[ 315 ]")) << shown;
  EXPECT_TRUE(shows("[ ]")) << "released automatically; " << shown;
  type("q");
  EXPECT_TRUE(shows("[ 81 ]")) << shown;
  EXPECT_EQ(ending(), 0);
  EXPECT_TRUE(isAsBefore());
}

class ReportingTerminal : public Terminal {
 protected:
  void startReporting() {
    replies = true;
    start();
    ASSERT_TRUE(shows(std::string{terminal::kStartReports})) << shown;
  }
};

TEST_F(ReportingTerminal, HoldsSeveralKeysUntilTheyAreReleased) {
  startReporting();
  type("\x1b[A\x1b[32u");
  EXPECT_TRUE(shows("[ 315 32 ]")) << shown;
  type("\x1b[32;1:3u");
  EXPECT_TRUE(shows("[ 315 ]")) << shown;
  type("\x1b[1;1:3A");
  EXPECT_TRUE(shows("[ ]")) << shown;
  type("\x1b[113u");  // q
  EXPECT_TRUE(shows(std::string{terminal::kEndReports})) << shown;
  EXPECT_EQ(ending(), 0);
}

TEST_F(ReportingTerminal, ReleasesItsKeysWhenItLosesTheFocus) {
  startReporting();
  type("\x1b[A");
  EXPECT_TRUE(shows("[ 315 ]")) << shown;
  type("\x1b[O");
  EXPECT_TRUE(shows("[ ]")) << shown;
}

TEST_F(ReportingTerminal, HoldsAKeyAsLongAsItReplies) {
  startReporting();
  type("\x1b[A");
  ASSERT_TRUE(shows("[ 315 ]")) << shown;
  constexpr int kMoreThanASilence = 12;  // a silence has 1 s
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_TRUE(asks(queries + kMoreThanASilence)) << queries;
  EXPECT_GE(std::chrono::steady_clock::now() - begun, std::chrono::seconds{1}) << "it asks every 0.1 s, not more often";
  EXPECT_THAT(shown, testing::Not(HasSubstr("[ ]")));
}

TEST_F(ReportingTerminal, ReleasesItsKeysWhenItRepliesNoMore) {
  startReporting();
  type("\x1b[A");
  EXPECT_TRUE(shows("[ 315 ]")) << shown;
  replies = false;
  EXPECT_TRUE(shows("[ ]")) << shown;
}

TEST_F(ReportingTerminal, InterruptsTheProgramAtControlC) {
  startReporting();
  type("\x1b[99;5u");
  EXPECT_TRUE(shows(std::string{terminal::kEndReports})) << shown;
  EXPECT_TRUE(becomesAsBefore());
}

TEST_F(ReportingTerminal, IsRestoredAfterACrash) {
  startReporting();
  type("\x1b[120u");  // x
  EXPECT_TRUE(shows(std::string{terminal::kEndReports})) << shown;
  EXPECT_EQ(ending(), 128 + SIGABRT);
  EXPECT_TRUE(isAsBefore());
}

TEST_F(Terminal, IsRestoredAfterTheFirstInterrupt) {
  start();
  ASSERT_TRUE(shows(kKeysFromTerminal)) << shown;
  type("\x03");
  EXPECT_TRUE(becomesAsBefore());
  EXPECT_EQ(kill(pid, SIGKILL), 0);
  EXPECT_EQ(ending(), 128 + SIGKILL);
  EXPECT_TRUE(isAsBefore());
}

TEST_F(Terminal, IsRestoredAfterACrash) {
  start();
  ASSERT_TRUE(shows(kKeysFromTerminal)) << shown;
  EXPECT_FALSE(isAsBefore());
  type("x");
  EXPECT_EQ(ending(), 128 + SIGABRT);
  EXPECT_TRUE(isAsBefore());
}

TEST_F(Terminal, IsRestoredAfterASignalThatEndsTheProgramAtOnce) {
  start();
  ASSERT_TRUE(shows(kKeysFromTerminal)) << shown;
  type("\x1c");  // Ctrl-backslash
  EXPECT_EQ(ending(), 128 + SIGQUIT);
  EXPECT_TRUE(isAsBefore());
}

TEST_F(Terminal, IsNotChangedIfNotUsed) {
  start("none");
  ASSERT_TRUE(shows("listening")) << shown;
  type("q\n");
  EXPECT_TRUE(isAsBefore());
  type("\x03");
  EXPECT_EQ(ending(), 0);
}

TEST(Keys, FromAnUnknownSourceAreRejected) {
  const std::atomic<bool> ending{false};
  EXPECT_THROW(static_cast<void>(openKeys({.from = "piano", .display = ""}, ending)), std::runtime_error);
}

/// Standard input must not be a terminal here.
TEST(Keys, WithoutASourceAreReportedOnce) {
  const int kept = dup(0);
  std::FILE* const nothing = std::fopen("/dev/null", "r");
  dup2(fileno(nothing), 0);
  std::atomic<bool> said{false};
  std::string what;
  {
    const std::atomic<bool> ending{false};
    const auto keys = openKeys({.from = "",
                                .display = ":x",
                                .log =
                                    [&](const std::string& text) {
                                      what = text;
                                      said = true;
                                    }},
                               ending);
    for (int i = 0; i < 2000 && !said; ++i) std::this_thread::sleep_for(std::chrono::milliseconds{5});
    EXPECT_TRUE(keys->take().empty());
  }
  EXPECT_THAT(what, HasSubstr(kNoKeys));
  EXPECT_THAT(what, HasSubstr("DISPLAY=:x "));
  EXPECT_THAT(what, HasSubstr(terminal::kInputNotATerminal));
  dup2(kept, 0);
  close(kept);
  std::fclose(nothing);
}

}  // namespace
}  // namespace darwinop::connect
