// Waits for a device, interruptible through an eventfd.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace darwinop::v4l2 {

class Wake {
 public:
  enum class Why : std::uint8_t { kStop, kTimeout, kReady, kPollError };  // kPollError: POLLERR and the like

  Wake();  // throws std::system_error: no file descriptors left
  ~Wake();
  Wake(const Wake&) = delete;
  Wake& operator=(const Wake&) = delete;

  /// Any thread: ends this and every later wait.
  void stop() noexcept;
  [[nodiscard]] bool stopped() const noexcept { return stopped_.load(std::memory_order_acquire); }

  /// Waits until `fd` is readable, at most `timeout`. An `fd` of -1 only waits.
  Why wait(int fd, std::chrono::nanoseconds timeout) const noexcept;

 private:
  int event_ = -1;
  std::atomic<bool> stopped_{false};
};

}  // namespace darwinop::v4l2
