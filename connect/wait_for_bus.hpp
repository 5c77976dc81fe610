// A daemon that is started at boot is there before its USB port.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "connect/connect.hpp"

namespace darwinop::connect {

/// Calls `open` until it succeeds, and pauses between the attempts: 0.2 s, then longer, 2 s at most. Waits only for
/// what may come yet (cm730::NotReady); every other error is thrown at once. Logs what it waits for, again
/// when that changes, and once that it came. Nothing: `stop` became true.
std::optional<OpenedBus> waitForBus(const std::function<OpenedBus()>& open, const std::atomic<bool>& stop,
                                    const std::function<void(const std::string&)>& log,
                                    const std::function<void(Nanos)>& pause);

/// Sleeps; a signal ends it early.
void pauseFor(Nanos time);

}  // namespace darwinop::connect
