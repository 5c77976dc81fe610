#include "hal/keyboard_terminal/key_terminal.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>

namespace darwinop::terminal {
namespace {

constexpr int kLookMs = 50;

Nanos monotonic() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

}  // namespace

KeyTerminal::End KeyTerminal::run(int stop_fd, const std::atomic<bool>& ending) {
  std::array<pollfd, 2> files{{{stop_fd, POLLIN, 0}, {fd_, POLLIN, 0}}};
  End end = End::kStopped;
  while (!ending) {
    const int ready = ::poll(files.data(), files.size(), kLookMs);
    if (ready > 0 && files[0].revents != 0) break;
    if (ready > 0 && files[1].revents != 0 && (!readAll() || (files[1].revents & POLLHUP) != 0)) {
      end = End::kTerminalGone;
      break;
    }
    const Nanos now = monotonic();
    if (const auto key = decoder_.timeOut(now)) typed_.type(*key, now);
    typed_.expire(now);
  }
  keys_.releaseAll();
  return end;
}

/// Returns false if the terminal is closed, or if this program is now in its background.
bool KeyTerminal::readAll() {
  std::array<char, 64> bytes{};
  const ssize_t count = ::read(fd_, bytes.data(), bytes.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  const Nanos now = monotonic();
  for (const Key key : decoder_.feed({bytes.data(), static_cast<std::size_t>(count)}, now)) typed_.type(key, now);
  return true;
}

}  // namespace darwinop::terminal
