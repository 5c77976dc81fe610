// Embedded loop.
#include "runtime/threaded_link.hpp"

#include <thread>

namespace darwinop::runtime {

ThreadedLink::ThreadedLink(const LoopConfig& config, std::unique_ptr<ServoBus> bus)
    : ExchangeLink{Exchange::embedded()},
      rest_{checked(config).safety, config.period},
      host_{config, std::move(bus), exchange(), LoopStats::Timed::kYes, Recorder::Writer::kThread},
      driver_{host_.loop(), clock_, config.period, config.real_time},
      watch_{block().sensors, config.trunk_is_held} {
  beginSession();
}

bool ThreadedLink::waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) {
  constexpr Nanos kCheckInterval{50'000'000};  // for a `stop` that another thread sets; a signal ends the sleep early
  for (;;) {
    if (stop.load()) return end(kAskedToStop);
    if (exchange().lost()) return end(kExchangeLost);
    const std::uint32_t seen = block().finished.value();
    if (finished(cycle)) return true;
    sleepUntilAfter(seen, kCheckInterval);
  }
}

ThreadedLink::~ThreadedLink() {
  if (!publishEndOfSession()) return;
  const Nanos give_up = now() + rest_.atMost(sensors());
  const std::atomic<bool> go_on{false};
  for (Sensors seen = sensors(); !rest_.reached(seen) && now() < give_up; seen = sensors())
    if (!waitForCycle(seen.cycle + 1, go_on)) std::this_thread::sleep_for(period());  // cannot be read any more
}

}  // namespace darwinop::runtime
