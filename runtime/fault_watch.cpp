// Thread that reports faults while an embedded loop runs.
#include "runtime/fault_watch.hpp"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <ostream>

#include "hal/diagnostics.hpp"
#include "runtime/fault_announcer.hpp"

namespace darwinop::runtime {

FaultWatch::FaultWatch(const Latest<Sensors>& sensors, bool trunk_is_held)
    : sensors_{sensors}, trunk_is_held_{trunk_is_held}, thread_{[this] { run(); }} {}

FaultWatch::~FaultWatch() {
  {
    const std::lock_guard lock{mutex_};
    stop_ = true;
  }
  ending_.notify_one();
  thread_.join();
}

void FaultWatch::run() {
  pthread_setname_np(pthread_self(), "darwinop-faults");
  sigset_t all;  // signals must interrupt the controller's thread, not this one
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  NeverWaitingBuffer buffer{STDERR_FILENO};  // the end of the loop must not wait for a reader of stderr
  std::ostream out{&buffer};
  FaultAnnouncer announcer{out, trunk_is_held_};
  Sensors seen;
  std::unique_lock lock{mutex_};
  for (bool last = false; !last;) {
    last = ending_.wait_for(lock, std::chrono::milliseconds{100}, [this] { return stop_; });
    if (sensors_.read(seen)) announcer.update(seen);
  }
}

}  // namespace darwinop::runtime
