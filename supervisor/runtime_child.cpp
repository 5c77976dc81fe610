// The runtime as a child.
#include "supervisor/runtime_child.hpp"

#include <stdexcept>

#include "runtime/file_lock.hpp"

namespace darwinop::supervisor {

/// The file of a runtime that ran before may still be there: it counts from when it names this one.
void RuntimeChild::attach() {
  if (runtime::FileLock::holder(files_.loop_lock) != child_.pid()) return;
  try {
    runtime::Exchange exchange = runtime::Exchange::attach(files_.exchange);
    if (exchange.block().info.pid == child_.pid() && exchange.block().stats.cycles() > 0)
      exchange_ = std::move(exchange);
  } catch (const std::runtime_error&) {
    return;  // not there yet
  }
}

RuntimeChild::State RuntimeChild::look(Nanos now) {
  if (child_.ended()) {
    if (exchange_) (void)exchange_->block().sensors.read(seen_);  // its last image: does the robot rest?
    return State::kEnded;
  }
  if (!exchange_) attach();
  if (!exchange_) return State::kStarting;
  if (!heart_) heart_.emplace(Nanos{exchange_->block().info.period_ns});
  (void)exchange_->block().sensors.read(seen_);
  return heart_->beats(exchange_->block().finished.value(), now) ? State::kUp : State::kSilent;
}

}  // namespace darwinop::supervisor
