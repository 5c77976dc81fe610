#include "monitor/onlooker.hpp"

#include <stdexcept>
#include <utility>

#include "runtime/file_lock.hpp"
#include "runtime/operator.hpp"

namespace darwinop::monitor {

bool Onlooker::look(Nanos now) {
  if (now < next_look_) return false;
  next_look_ = now + kLook;
  std::string why = whyNone(now);
  return std::exchange(reason_, why) != why;
}

std::string Onlooker::whyNone(Nanos now) {
  if (!exchange_) {
    try {
      exchange_.emplace(runtime::lookAtDaemon(files_));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    moved_ = now;
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
    exchange_.reset();  // the next one has a memory of its own
    return "the runtime (pid " + pid + ") has ended; start it again with: darwinop runtime";
  }
  if (const std::uint32_t finished = block.finished.value(); finished != std::exchange(finished_, finished))
    moved_ = now;
  if (now - moved_ >= kHung)
    return "the runtime (pid " + pid +
           ") lives but has not run a cycle for 5 s; look at it with: darwinop runtime --status";
  return {};
}

const runtime::ExchangeBlock* Onlooker::block() const {
  return exchange_ && reason_.empty() ? &exchange_->block() : nullptr;
}

pid_t Onlooker::driver() const {
  return runtime::FileLock::holder(files_.drive_lock);
}

}  // namespace darwinop::monitor
