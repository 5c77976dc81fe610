// Lets a thread wait for a device and be called away from it at once.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace darwinop::v4l2 {

class Wake {
 public:
  enum class Why : std::uint8_t { kStop, kTimeout, kReady, kTroubled };  // kTroubled: POLLERR and the like

  Wake();  // throws std::system_error: this process has no file descriptors left
  ~Wake();
  Wake(const Wake&) = delete;
  Wake& operator=(const Wake&) = delete;

  /// Any thread: this and every later wait is over.
  void stop() noexcept;
  [[nodiscard]] bool stopped() const noexcept { return stopped_.load(std::memory_order_acquire); }

  /// Until `fd` can be read, at most `timeout`. An `fd` of -1: only time passes.
  Why wait(int fd, std::chrono::nanoseconds timeout) const noexcept;

 private:
  int event_ = -1;
  std::atomic<bool> stopped_{false};
};

}  // namespace darwinop::v4l2
