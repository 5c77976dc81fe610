// Signal table: documentation and actual effect.
#include "hal/signals.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include "support/text_of.hpp"

namespace darwinop {
namespace {

TEST(Signals, TheTableHasEachOf31SignalsOnce) {
  std::set<int> numbers;
  for (const SignalRow& row : kSignals) numbers.insert(row.number);
  EXPECT_EQ(numbers.size(), 31u);
  EXPECT_EQ(*numbers.begin(), 1);
  EXPECT_EQ(*numbers.rbegin(), 31);
}

int fateOfChild(pid_t child) {
  int status = 0;
  waitpid(child, &status, WUNTRACED);
  if (!WIFSTOPPED(status)) return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  return -1000;
}

/// Sanitizers install handlers of their own.
void defaultSignals() {
  for (const SignalRow& row : kSignals) signal(row.number, SIG_DFL);
}

/// Raises the signal in a child process. Exit code 10: the end flag was set; 20: no effect.
int fateOf(int signal) {
  const pid_t child = fork();
  if (child == 0) {
    defaultSignals();
    endOnSignals();
    raise(signal);
    _exit(endRequested() ? 10 : 20);
  }
  return fateOfChild(child);
}

TEST(Signals, EachHasTheEffectInTheTable) {
  for (const SignalRow& row : kSignals) {
    int wanted = 20;
    if (row.effect == SignalEffect::kEnds) wanted = 10;
    if (row.effect == SignalEffect::kKills) wanted = -row.number;
    if (row.effect == SignalEffect::kStops) wanted = -1000;
    EXPECT_EQ(fateOf(row.number), wanted) << row.name;
  }
  EXPECT_EQ(fateOf(SIGRTMIN), 20);
  EXPECT_EQ(fateOf(SIGRTMAX), 20);
}

/// The same for a program that waits in sigtimedwait().
int fateOfOneThatWaits(int signal, bool by_nohup = false) {
  const pid_t child = fork();
  if (child == 0) {
    if (by_nohup) ::signal(SIGHUP, SIG_IGN);
    const sigset_t set = blockEndSignals();
    raise(signal);
    const timespec now{};
    _exit(sigtimedwait(&set, nullptr, &now) == signal ? 10 : 20);
  }
  return fateOfChild(child);
}

TEST(Signals, AWaitingProgramReceivesOnlyEndingSignals) {
  for (const SignalRow& row : kSignals) {
    if (row.effect != SignalEffect::kEnds && row.effect != SignalEffect::kIgnored) continue;
    EXPECT_EQ(fateOfOneThatWaits(row.number), row.effect == SignalEffect::kEnds ? 10 : 20) << row.name;
  }
}

TEST(Signals, NohupKeepsAWaitingProgramAlive) {
  EXPECT_EQ(fateOfOneThatWaits(SIGHUP, true), 20);
  EXPECT_EQ(fateOfOneThatWaits(SIGTERM, true), 10);
}

std::string effectText(SignalEffect effect) {
  if (effect == SignalEffect::kEnds) return "ends normally";
  if (effect == SignalEffect::kKills) return "ends at once";
  return "stops";
}

TEST(Signals, TheDocumentationHasTheSameTable) {
  std::string page = textOf(DARWINOP_DOCS "/threads.md");
  std::ranges::replace(page, '\n', ' ');
  std::string without = "No effect: ";
  for (const SignalRow& row : kSignals) {
    if (row.effect == SignalEffect::kIgnored || row.effect == SignalEffect::kNoEffect) {
      without += std::string{row.name} + ", ";
      continue;
    }
    const std::string line =
        "| " + std::string{row.name} + " | " + effectText(row.effect) + " | " + std::string{row.cause} + " |";
    EXPECT_NE(page.find(line), std::string::npos) << "docs/threads.md lacks: " << line;
  }
  EXPECT_NE(page.find(without), std::string::npos) << "docs/threads.md lacks: " << without;
}

TEST(Signals, NohupHolds) {
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGHUP, SIG_IGN);
    endOnSignals();
    raise(SIGHUP);
    _exit(endRequested() ? 10 : 20);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 20);
}

}  // namespace
}  // namespace darwinop
