// The runtime as a child process.
#include "supervisor/runtime_child.hpp"

#include <utility>

#include "runtime/file_lock.hpp"
#include "safety/session_settings.hpp"

namespace darwinop::supervisor {

/// The file of an earlier runtime may still exist; it is valid once it contains this pid.
void RuntimeChild::attach() {
  if (runtime::FileLock::holder(files_.loop_lock) != child_.pid()) return;
  auto exchange = runtime::ExchangeReader::open(files_.exchange);
  if (exchange && exchange->block().info.pid == child_.pid() && exchange->block().finished.value() > 0)
    exchange_ = std::move(exchange);
}

safety::Config RuntimeChild::safety() const {
  if (!exchange_) return {};
  const runtime::LoopInfo& info = exchange_->block().info;
  return safety::fromSession(info.safety, info.safety_named);
}

/// After truncation of the file the last copy stays, with a constant cycle counter: the runtime counts as hung.
RuntimeChild::State RuntimeChild::update(Nanos now) {
  if (!exchange_ && !child_.ended()) attach();
  if (exchange_ && exchange_->refresh()) (void)exchange_->sensors(seen_);
  if (child_.ended()) return State::kEnded;  // its last image shows whether the robot is at rest
  if (!exchange_) return State::kStarting;
  if (!heart_) heart_.emplace(Nanos{exchange_->block().info.period_ns});
  return heart_->beats(exchange_->block().finished.value(), now) ? State::kUp : State::kSilent;
}

}  // namespace darwinop::supervisor
