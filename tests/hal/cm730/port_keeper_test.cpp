// PortKeeper with fake file descriptors.
#include "hal/cm730/port_keeper.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <new>
#include <vector>

namespace darwinop::cm730 {
namespace {

using namespace std::chrono_literals;

/// A port that can be opened from attempt `ready_at` on.
struct FakePort {
  std::mutex mutex;
  int attempts = 0, ready_at = 1;
  std::vector<int> closed;

  PortKeeper::Config config(Nanos wait = 1ms) {
    return {[this] {
              const std::lock_guard lock{mutex};
              return ++attempts >= ready_at ? 100 + attempts : -1;
            },
            [this](int fd) {
              const std::lock_guard lock{mutex};
              closed.push_back(fd);
            },
            wait, wait};
  }
  int attemptsSoFar() {
    const std::lock_guard lock{mutex};
    return attempts;
  }
};

template <class Condition>
bool waitFor(Condition&& met) {
  const auto limit = std::chrono::steady_clock::now() + 20s;
  while (!met()) {
    if (std::chrono::steady_clock::now() > limit) return false;
    std::this_thread::yield();
  }
  return true;
}

int waitForNew(PortKeeper& keeper) {
  int fd = -1;
  waitFor([&] { return (fd = keeper.takeNew()) >= 0; });
  return fd;
}

TEST(PortKeeper, DoesNothingWhileThePortWorks) {
  FakePort port;
  PortKeeper keeper{port.config()};
  EXPECT_EQ(keeper.takeNew(), -1);
  EXPECT_EQ(port.attemptsSoFar(), 0);
}

TEST(PortKeeper, ClosesTheDeadFileAndRetriesUntilAnotherOpens) {
  FakePort port;
  port.ready_at = 4;
  PortKeeper keeper{port.config()};
  keeper.giveUp(7);
  EXPECT_EQ(waitForNew(keeper), 104);
  EXPECT_EQ(keeper.takeNew(), -1) << "a descriptor is handed over once";
  EXPECT_EQ(port.closed, std::vector<int>{7});
}

TEST(PortKeeper, ReopensAPortRepeatedly) {
  FakePort port;
  PortKeeper keeper{port.config()};
  int fd = 7;
  for (int i = 0; i < 50; ++i) {
    keeper.giveUp(fd);
    fd = waitForNew(keeper);
    ASSERT_EQ(fd, 101 + i);
  }
  EXPECT_EQ(port.closed.size(), 50u);
}

TEST(PortKeeper, WaitsBetweenAttempts) {
  FakePort port;
  port.ready_at = 1000;
  PortKeeper keeper{port.config(1h)};
  keeper.giveUp(7);
  ASSERT_TRUE(waitFor([&] { return port.attemptsSoFar() == 1; }));
  EXPECT_EQ(keeper.takeNew(), -1);
  EXPECT_EQ(port.attemptsSoFar(), 1);
}  // and ends at once, in the middle of the hour

TEST(PortKeeper, ClosesUnclaimedFiles) {
  FakePort port;
  {
    PortKeeper keeper{port.config()};
    keeper.giveUp(7);
    ASSERT_TRUE(waitFor([&] { return port.attemptsSoFar() == 1; }));
  }
  EXPECT_EQ(port.closed, (std::vector<int>{7, 101}));
}

TEST(PortKeeper, SurvivesAnAttemptThatThrows) {
  FakePort port;
  PortKeeper::Config config = port.config();
  config.open = [&port, open = config.open] {
    const int fd = open();
    if (port.attemptsSoFar() == 1) throw std::bad_alloc{};
    return fd;
  };
  PortKeeper keeper{config};
  keeper.giveUp(7);
  EXPECT_EQ(waitForNew(keeper), 102);
}

}  // namespace
}  // namespace darwinop::cm730
