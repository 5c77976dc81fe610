#include "window/live/runtime_source.hpp"

namespace darwinop::window {

void RuntimeSource::poll(Nanos now, const Take& take) {
  if (runtime_.update(now)) {
    commands_.reset();
    if (const runtime::ExchangeBlock* block = runtime_.block())
      commands_ = runtime::CommandObserver::attach(exchange_, *block);
  }
  const runtime::ExchangeBlock* const block = runtime_.block();
  const std::uint64_t before = cycle_.sensors.cycle;
  if (block == nullptr || !block->sensors.read(cycle_.sensors) || cycle_.sensors.cycle == before) return;
  cycle_.p_gain.fill(kUnknown);
  if (commands_) cycle_.p_gain = commands_->pGains();
  take(cycle_);
}

}  // namespace darwinop::window
