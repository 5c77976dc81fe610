// The first Ctrl-C of an experiment: it ends, and the robot goes back slowly. The second is the API's.
#pragma once

#include <atomic>

namespace darwinop::experiments {

/// To be called once the webots::Robot exists, whose own handlers then come into force with the second signal.
/// Becomes true with the first signal of kEndSignals (hal/signals.hpp).
const std::atomic<bool>& installGentleStop();

}  // namespace darwinop::experiments
