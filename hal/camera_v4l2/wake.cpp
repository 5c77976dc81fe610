// poll() on a device and an eventfd.
#include "hal/camera_v4l2/wake.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

namespace darwinop::v4l2 {

Wake::Wake() : event_{::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)} {
  if (event_ < 0)
    throw std::system_error{errno, std::generic_category(), "cannot create an eventfd for the camera's thread"};
}

Wake::~Wake() {
  ::close(event_);
}

void Wake::stop() noexcept {
  stopped_.store(true, std::memory_order_release);
  const std::uint64_t one = 1;
  static_cast<void>(!::write(event_, &one, sizeof one));
}

Wake::Why Wake::wait(int fd, std::chrono::nanoseconds timeout) const noexcept {
  using std::chrono::ceil, std::chrono::milliseconds, std::chrono::hours;
  // Rounded up: a wait of 0 ms near the timeout would spin.
  const auto limited = ceil<milliseconds>(std::clamp<std::chrono::nanoseconds>(timeout, milliseconds{0}, hours{1}));
  std::array<pollfd, 2> files{{{event_, POLLIN, 0}, {fd, POLLIN, 0}}};
  const int count = ::poll(files.data(), files.size(), static_cast<int>(limited.count()));
  if (stopped()) return Why::kStop;
  if (count <= 0) return Why::kTimeout;  // or a signal: the caller checks the clock
  if ((files[1].revents & POLLIN) != 0) return Why::kReady;
  return files[1].revents != 0 ? Why::kPollError : Why::kTimeout;
}

}  // namespace darwinop::v4l2
