// Reopens a lost port: a thread closes the dead file descriptor and tries to open a new one.
#pragma once

#include <semaphore.h>

#include <atomic>
#include <functional>
#include <thread>

#include "hal/byte_line.hpp"

namespace darwinop::cm730 {

/// Descriptors are exchanged through two atomics, one per direction; each side owns what it took.
class PortKeeper {
 public:
  struct Config {
    std::function<int()> open;       // an open descriptor, or -1: not yet. Called by the keeper's thread.
    std::function<void(int)> close;  // also called by the destructor
    Nanos first_wait{50'000'000};    // between attempts; doubles
    Nanos longest_wait{1'000'000'000};
  };

  explicit PortKeeper(Config config);
  ~PortKeeper();
  PortKeeper(const PortKeeper&) = delete;
  PortKeeper& operator=(const PortKeeper&) = delete;

  /// Loop's thread: `fd` is dead, reopen. Call once per descriptor.
  void giveUp(int fd) noexcept;
  /// Loop's thread: the new descriptor, or -1: none yet.
  [[nodiscard]] int takeNew() noexcept;

 private:
  void run();
  int openPatiently();
  void sleep(Nanos duration);

  static constexpr int kNone = -1;
  Config config_;
  std::atomic<int> dead_{kNone}, fresh_{kNone};
  std::atomic<bool> stop_{false};
  sem_t work_{};  // posting takes no lock, unlike a condition variable
  std::thread thread_;
};

}  // namespace darwinop::cm730
