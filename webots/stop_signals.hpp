// Ctrl-C, SIGTERM and SIGHUP as a flag, so that a controller can end tidily; SIGPIPE without effect.
#pragma once

#include <atomic>

namespace darwinop::facade {

/// Becomes true with the first SIGINT, SIGTERM or SIGHUP after installStopSignals().
const std::atomic<bool>& stopRequested();

/// The first signal sets the flag; a second SIGINT or SIGTERM, from 0.3 s after the first, ends the program at once. A
/// signal that the program's parent chose to ignore stays ignored. Output into a pipe that nobody reads any more, as in
/// `| head -3`, no longer kills the program, unless it has a handler of its own for that.
void installStopSignals();

}  // namespace darwinop::facade
