// Robot link in simulated time.
#include "runtime/lockstep_link.hpp"

#include <iostream>
#include <utility>

namespace darwinop::runtime {

LockstepLink::LockstepLink(const LoopConfig& config, std::unique_ptr<ServoBus> bus, std::unique_ptr<Clock> clock,
                           CameraOpener open_camera)
    : ExchangeLink{Exchange::embedded()},
      rest_{checked(config).safety, config.period},
      clock_{std::move(clock)},
      host_{config, std::move(bus), exchange(), LoopStats::Timed::kNo, Recorder::Writer::kByHand},
      driver_{host_.loop(), *clock_, config.period},
      open_camera_{std::move(open_camera)},
      announcer_{std::cerr, config.trunk_is_held} {
  beginSession();
}

bool LockstepLink::waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) {
  while (!finished(cycle)) {
    if (stop.load()) return end(kAskedToStop);
    run();
  }
  return stop.load() ? end(kAskedToStop) : true;
}

std::unique_ptr<FrameSource> LockstepLink::openCamera(int width, int height) {
  return open_camera_ ? open_camera_(width, height) : nullptr;
}

void LockstepLink::run() {
  driver_.run(1);
  if (host_.recorder() != nullptr) host_.recorder()->drain();
  announcer_.update(sensors());
}

LockstepLink::~LockstepLink() {
  if (!publishEndOfSession()) return;
  const auto at_most = static_cast<std::uint64_t>(rest_.atMost(sensors()) / period());
  for (std::uint64_t cycles = 0; !rest_.reached(sensors()) && cycles < at_most; ++cycles) run();
}

}  // namespace darwinop::runtime
