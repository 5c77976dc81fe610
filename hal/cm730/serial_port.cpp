// Serial port I/O: read() and write() first, ppoll() only when they would block.
#include "hal/cm730/serial_port.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <ctime>
#include <stdexcept>
#include <utility>

#include "hal/cm730/not_ready.hpp"
#include "hal/cm730/serial_open.hpp"
#include "hal/cm730/wire.hpp"

namespace darwinop::cm730 {
namespace {

// The kernel buffer holds many frames, so a write blocks only if the device stops reading.
constexpr Nanos kWriteMargin{2'000'000};
// Stale input is a few frames at most; continuous garbage must not block the loop.
constexpr int kMostDiscards = 16;

int openOrThrow(const std::string& path) {
  const OpenAttempt attempt = openSerial(path);
  if (attempt.fd < 0 && mayComeYet(attempt)) throw NotReady{explain(path, attempt)};
  if (attempt.fd < 0) throw std::runtime_error{explain(path, attempt)};
  return attempt.fd;
}

bool wouldWait(ssize_t result) {
  return result == 0 || errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

timespec toTimespec(Nanos duration) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  return {static_cast<time_t>(duration.count() / kSecond), static_cast<long>(duration.count() % kSecond)};
}

}  // namespace

SerialPort::SerialPort(const std::string& path)
    : SerialPort{openOrThrow(path), {[memory = PortMemory{path}] { return memory.reopen(); }, closeSerial}} {}

SerialPort::SerialPort(int fd, PortKeeper::Config keeper) : fd_{fd}, keeper_{std::move(keeper)} {}

SerialPort::~SerialPort() {
  closeSerial(fd_);
}

Nanos SerialPort::now() noexcept {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::chrono::seconds{time.tv_sec} + Nanos{time.tv_nsec};
}

bool SerialPort::present() noexcept {
  if (fd_ >= 0) return true;
  fd_ = keeper_.takeNew();
  if (fd_ < 0) return false;
  ++reconnects_;
  return true;
}

LineStatus SerialPort::lose() noexcept {
  keeper_.giveUp(std::exchange(fd_, -1));
  return LineStatus::kLost;
}

LineStatus SerialPort::wait(short events, Nanos deadline, bool& hung_up) noexcept {
  const Nanos left = deadline - now();
  if (left <= Nanos::zero()) return LineStatus::kTimeout;
  pollfd file{fd_, events, 0};
  const timespec timeout = toTimespec(left);
  const int ready = ::ppoll(&file, 1, &timeout, nullptr);
  if (ready == 0) return LineStatus::kTimeout;
  if (ready < 0 && errno != EINTR) return LineStatus::kLost;
  // Linux: a pty without its other end and an unplugged adapter both poll as hung up and then read 0 bytes forever.
  hung_up = ready > 0 && (file.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
  return LineStatus::kOk;
}

LineStatus SerialPort::write(std::span<const std::uint8_t> bytes) noexcept {
  if (!present()) return LineStatus::kLost;
  Nanos deadline{0};  // set when a wait is needed
  while (!bytes.empty()) {
    const ssize_t taken = ::write(fd_, bytes.data(), bytes.size());
    if (taken > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(taken));
      continue;
    }
    if (!wouldWait(taken)) return lose();
    if (deadline == Nanos::zero()) deadline = now() + wireTime(bytes.size()) + kWriteMargin;
    bool hung_up = false;
    const LineStatus status = wait(POLLOUT, deadline, hung_up);
    if (status == LineStatus::kLost || hung_up) return lose();
    if (status == LineStatus::kTimeout) return status;
  }
  return LineStatus::kOk;
}

LineStatus SerialPort::read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept {
  count = 0;
  if (!present()) return LineStatus::kLost;
  bool hung_up = false;
  while (true) {
    const ssize_t got = ::read(fd_, into.data(), into.size());
    if (got > 0) {
      count = static_cast<std::size_t>(got);
      return LineStatus::kOk;
    }
    if (hung_up || !wouldWait(got)) return lose();
    const LineStatus status = wait(POLLIN, deadline, hung_up);
    if (status == LineStatus::kLost) return lose();
    if (status == LineStatus::kTimeout) return status;
  }
}

void SerialPort::discardInput() noexcept {
  if (!present()) return;
  std::array<std::uint8_t, 512> rubbish;
  for (int i = 0; i < kMostDiscards; ++i)
    if (::read(fd_, rubbish.data(), rubbish.size()) <= 0) return;
}

}  // namespace darwinop::cm730
