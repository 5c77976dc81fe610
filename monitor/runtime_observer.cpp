// Detects start, end and hang of a runtime.
#include "monitor/runtime_observer.hpp"

#include <stdexcept>
#include <utility>

#include "runtime/file_lock.hpp"
#include "runtime/messages.hpp"
#include "runtime/operator.hpp"

namespace darwinop::monitor {

bool RuntimeObserver::update(Nanos now) {
  if (now < next_check_) return false;
  next_check_ = now + kCheckInterval;
  std::string why = whyUnavailable(now);
  return std::exchange(reason_, why) != why;
}

std::string RuntimeObserver::whyUnavailable(Nanos now) {
  if (!exchange_) {
    try {
      exchange_.emplace(runtime::observeDaemon(files_));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    advanced_at_ = now;
    finished_ = exchange_->block().finished.value();
  }
  if (exchange_->lost()) {
    exchange_.reset();
    return runtime::kExchangeLost;
  }
  const runtime::ExchangeBlock& block = exchange_->block();
  const std::string pid = std::to_string(block.info.pid);
  const pid_t living = runtime::FileLock::holder(files_.loop_lock);
  if (living != block.info.pid && living != -1) {
    exchange_.reset();  // the next runtime creates new memory
    return "the runtime (pid " + pid + runtime::messages::kRuntimeHasEnded;
  }
  if (const std::uint32_t finished = block.finished.value(); finished != std::exchange(finished_, finished))
    advanced_at_ = now;
  if (now - advanced_at_ >= kHung) return "the runtime (pid " + pid + ")" + kHangs;
  return {};
}

const runtime::ExchangeBlock* RuntimeObserver::block() const {
  return exchange_ && reason_.empty() ? &exchange_->block() : nullptr;
}

pid_t RuntimeObserver::driver() const {
  return runtime::FileLock::holder(files_.drive_lock);
}

}  // namespace darwinop::monitor
