// Brings a lost port back: a thread of its own closes the dead file and tries to open it again.
#pragma once

#include <semaphore.h>

#include <atomic>
#include <functional>
#include <thread>

#include "hal/byte_line.hpp"

namespace darwinop::cm730 {

/// Files change hands through two atomics, one for each direction; each side owns what it took.
class PortKeeper {
 public:
  struct Config {
    std::function<int()> open;       // a ready file, or -1: not yet. Called by the keeper's thread.
    std::function<void(int)> close;  // also by the destructor
    Nanos first_wait{50'000'000};    // between attempts; doubles
    Nanos longest_wait{1'000'000'000};
  };

  explicit PortKeeper(Config config);
  ~PortKeeper();
  PortKeeper(const PortKeeper&) = delete;
  PortKeeper& operator=(const PortKeeper&) = delete;

  /// Loop's thread: this file is dead, find another. Call once for each file.
  void giveUp(int fd) noexcept;
  /// Loop's thread: the new file, or -1 while there is none.
  [[nodiscard]] int takeNew() noexcept;

 private:
  void run();
  int openPatiently();
  void sleep(Nanos duration);

  static constexpr int kNone = -1;
  Config config_;
  std::atomic<int> dead_{kNone}, fresh_{kNone};
  std::atomic<bool> stop_{false};
  sem_t work_{};  // posting it takes no lock, unlike a condition variable
  std::thread thread_;
};

}  // namespace darwinop::cm730
