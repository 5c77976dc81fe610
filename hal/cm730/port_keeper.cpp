// Thread that reopens a lost port.
#include "hal/cm730/port_keeper.hpp"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <utility>

namespace darwinop::cm730 {
namespace {

/// The creating thread may be real-time, and the main thread handles signals.
void becomeOrdinary() {
  const sched_param none{};
  ::pthread_setschedparam(::pthread_self(), SCHED_OTHER, &none);
}

timespec monotonicIn(Nanos duration) {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  const std::int64_t nanoseconds = now.tv_nsec + duration.count();
  constexpr std::int64_t kSecond = 1'000'000'000;
  now.tv_sec += static_cast<time_t>(nanoseconds / kSecond);
  now.tv_nsec = static_cast<long>(nanoseconds % kSecond);
  return now;
}

}  // namespace

PortKeeper::PortKeeper(Config config) : config_{std::move(config)} {
  ::sem_init(&work_, 0, 0);
  sigset_t all, before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);  // inherited by the new thread
  thread_ = std::thread{[this] { run(); }};
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

PortKeeper::~PortKeeper() {
  stop_ = true;
  ::sem_post(&work_);
  thread_.join();
  for (std::atomic<int>* slot : {&dead_, &fresh_})
    if (const int fd = slot->exchange(kNone); fd != kNone) config_.close(fd);
  ::sem_destroy(&work_);
}

void PortKeeper::giveUp(int fd) noexcept {
  dead_.store(fd, std::memory_order_release);
  ::sem_post(&work_);
}

int PortKeeper::takeNew() noexcept {
  if (fresh_.load(std::memory_order_relaxed) == kNone) return kNone;
  return fresh_.exchange(kNone, std::memory_order_acq_rel);
}

void PortKeeper::run() {
  becomeOrdinary();
  while (!stop_) {
    ::sem_wait(&work_);
    const int dead = dead_.exchange(kNone, std::memory_order_acq_rel);
    if (dead == kNone) continue;
    config_.close(dead);
    const int fresh = openPatiently();
    if (fresh != kNone) fresh_.store(fresh, std::memory_order_release);
  }
}

int PortKeeper::openPatiently() {
  for (Nanos wait = config_.first_wait; !stop_; wait = std::min(2 * wait, config_.longest_wait)) {
    try {
      if (const int fd = config_.open(); fd >= 0) return fd;
    } catch (...) {  // out of memory: retried like any other error
    }
    sleep(wait);
  }
  return kNone;
}

void PortKeeper::sleep(Nanos duration) {
  const timespec until = monotonicIn(duration);
  while (!stop_ && ::sem_clockwait(&work_, CLOCK_MONOTONIC, &until) != 0 && errno == EINTR) {
  }
}

}  // namespace darwinop::cm730
