// Signal handling of an experiment: the first signal ends it with a slow return, the second is handled by the API.
#pragma once

#include <atomic>

namespace darwinop::experiments {

/// Call after the webots::Robot is constructed: its handlers are restored for the second signal. The returned flag
/// becomes true with the first signal of kEndSignals (hal/signals.hpp).
const std::atomic<bool>& installGentleStop();

}  // namespace darwinop::experiments
