// Waits for the USB port: a daemon started at boot runs before it appears.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "connect/serial_bus.hpp"

namespace darwinop::connect {

/// Calls `open` until it succeeds, with a pause of 0.2 s, increasing to 2 s, between attempts. Retries only on
/// cm730::NotReady; other errors are thrown at once. Logs what it waits for, each change of it, and success. Returns
/// nothing if `stop` becomes true.
std::optional<OpenedBus> waitForBus(const std::function<OpenedBus()>& open, const std::atomic<bool>& stop,
                                    const std::function<void(const std::string&)>& log,
                                    const std::function<void(Nanos)>& pause);

/// Sleeps; a signal ends it early.
void pauseFor(Nanos time);

}  // namespace darwinop::connect
