// A robot in simulated time.
#include "runtime/lockstep_link.hpp"

namespace darwinop::runtime {

LockstepLink::LockstepLink(const LoopConfig& config, std::unique_ptr<ServoBus> bus, std::unique_ptr<Clock> clock)
    : ExchangeLink{Exchange::embedded()},
      rest_{config.safety.on_exit},
      clock_{std::move(clock)},
      host_{config, std::move(bus), block(), LoopStats::Timed::kNo, Recorder::Writer::kByHand},
      driver_{host_.loop(), *clock_, config.period} {
  beginSession();
}

bool LockstepLink::waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) {
  while (!finished(cycle)) {
    if (stop.load()) return end(kAskedToStop);
    run();
  }
  return stop.load() ? end(kAskedToStop) : true;
}

void LockstepLink::run() {
  driver_.run(1);
  if (host_.recorder() != nullptr) host_.recorder()->drain();
}

LockstepLink::~LockstepLink() {
  if (!sayFarewell()) return;
  const auto at_most = static_cast<std::uint64_t>(Rest::kAtMost / period());
  for (std::uint64_t cycles = 0; !rest_.reached(cycles, sensors()) && cycles < at_most; ++cycles) run();
}

}  // namespace darwinop::runtime
