// Ctrl-C and SIGTERM as a flag, so that a controller can end tidily.
#pragma once

#include <atomic>

namespace darwinop::facade {

/// Becomes true with the first SIGINT or SIGTERM after installStopSignals().
const std::atomic<bool>& stopRequested();

/// The first signal sets the flag and restores the default, so that a second one ends the program at once. A signal
/// that the program's parent chose to ignore stays ignored.
void installStopSignals();

}  // namespace darwinop::facade
