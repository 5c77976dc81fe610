// Thread that serves the pseudo terminal.
#include "hil-mocks/pty_host.hpp"

#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <sys/eventfd.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <stdexcept>

namespace darwinop::hil {
namespace {

constexpr Nanos kQuiet = std::chrono::milliseconds{500};  // after this silence no client is assumed
constexpr int kPriority = 70;

void becomeRealTime() {
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);  // if refused: runs with more delay
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
}

}  // namespace

PtyHost::PtyHost(VirtualRobot& robot, const PtyOptions& options)
    : robot_{robot},
      options_{options},
      pty_{std::make_unique<Pty>(options.link)},
      latency_{options.latency_timer},
      start_{std::chrono::steady_clock::now() - robot.now()},
      event_fd_{eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)} {
  if (event_fd_ < 0) throw std::runtime_error(std::string("cannot create an eventfd: ") + std::strerror(errno));
  thread_ = std::thread{[this] { serve(); }};
}

PtyHost::~PtyHost() {
  stop_ = true;
  wake();
  thread_.join();
  close(event_fd_);
}

std::string PtyHost::path() const {
  const std::lock_guard lock{mutex_};
  return pty_ ? pty_->path() : std::string{};
}

void PtyHost::wake() noexcept {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = write(event_fd_, &one, sizeof one);
}

void PtyHost::askRobot(const std::function<void(VirtualRobot&)>& action) {
  const std::uint32_t before = answered_.load();
  asked_.store(&action);
  wake();
  answered_.wait(before);
}

void PtyHost::answer() {
  const auto* const action = asked_.exchange(nullptr);
  if (action == nullptr) return;
  (*action)(robot_);
  ++answered_;
  answered_.notify_one();
}

void PtyHost::serve() {
  becomeRealTime();
  Nanos next = now();
  while (!stop_) {
    {
      const std::lock_guard lock{mutex_};
      takeInput();
      const Nanos time = now();
      robot_.advance(time);
      worst_lag_.store(std::max(worstLag(), now() - std::min(next, time)), std::memory_order_relaxed);
      plugOrUnplug();
      deliver(time);
      answer();
      next = nextWake(time);
    }
    sleepUntil(next);
  }
}

void PtyHost::takeInput() noexcept {
  std::array<std::uint8_t, 4096> bytes;
  if (!pty_) return;
  while (const std::size_t count = pty_->read(bytes)) {
    last_input_ = now();
    robot_.receive(Bytes{bytes}.first(count), last_input_);
  }
}

void PtyHost::plugOrUnplug() {
  if (robot_.portOpen() == (pty_ != nullptr)) return;
  latency_.clear();
  if (!robot_.portOpen()) return pty_.reset();
  try {
    pty_ = std::make_unique<Pty>(options_.link);
  } catch (const std::exception&) {
    // Retried at the next wake-up: the old client may still hold the last pseudo terminal of the system.
  }
}

void PtyHost::deliver(Nanos now) noexcept {
  if (!pty_) return;
  const auto send = [this](Bytes bytes) { pty_->write(bytes); };
  for (ChunkRing& output = robot_.output(); !output.empty() && output.front().at <= now; output.pop())
    latency_.take(output.front().bytes(), output.front().at, send);
  latency_.expire(now, send);
  if (now - last_input_ > kQuiet) {
    last_input_ = now;
    pty_->dropStaleClaim();
  }
}

Nanos PtyHost::nextWake(Nanos now) const noexcept {
  return std::min({robot_.nextWake().value_or(Nanos::max()), latency_.due(), now + options_.at_rest});
}

void PtyHost::sleepUntil(Nanos when) noexcept {
  const Nanos wait = std::max(when - now(), Nanos{0});
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(wait);
  const timespec timeout{static_cast<time_t>(seconds.count()), static_cast<long>((wait - seconds).count())};
  std::array<pollfd, 2> fds{{{event_fd_, POLLIN, 0}, {pty_ ? pty_->fd() : -1, POLLIN, 0}}};
  if (ppoll(fds.data(), fds.size(), &timeout, nullptr) > 0 && (fds[0].revents & POLLIN) != 0) {
    std::uint64_t count;
    [[maybe_unused]] const ssize_t taken = ::read(event_fd_, &count, sizeof count);
  }
}

}  // namespace darwinop::hil
