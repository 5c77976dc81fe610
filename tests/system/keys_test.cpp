// Keys of a real terminal, up to a controller that walks.
#include "connect/keys.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>

namespace darwinop {
namespace {

class WalkInATerminal : public testing::Test {
 protected:
  WalkInATerminal() : pid_{forkpty(&master_, nullptr, nullptr, nullptr)} {
    if (pid_ != 0) return;
    setenv("DARWINOP_ROBOT", "virtual", 1);
    setenv("DARWINOP_KEYS", "terminal", 1);
    execl(DARWINOP_WALK_BY_KEYS, DARWINOP_WALK_BY_KEYS, nullptr);
    _exit(127);
  }
  ~WalkInATerminal() override {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    close(master_);
  }

  void type(const std::string& bytes) const {
    ASSERT_EQ(write(master_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  bool shows(const std::string& text) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{60};
    while (shown_.find(text) == std::string::npos && std::chrono::steady_clock::now() < end) {
      pollfd ready{master_, POLLIN, 0};
      std::array<char, 256> part{};
      if (poll(&ready, 1, 100) != 1) continue;
      const ssize_t count = read(master_, part.data(), part.size());
      if (count <= 0) break;  // the program has ended
      shown_.append(part.data(), static_cast<std::size_t>(count));
    }
    return shown_.find(text) != std::string::npos;
  }

  int master_ = -1;
  pid_t pid_;
  std::string shown_;
};

TEST_F(WalkInATerminal, StartsOnceWhenTheSpaceBarIsTapped) {
  ASSERT_TRUE(shows(connect::kKeysFromTerminal)) << shown_;
  type(" ");
  EXPECT_TRUE(shows("starts: 1, stops: 0\r\n")) << shown_;
}

}  // namespace
}  // namespace darwinop
