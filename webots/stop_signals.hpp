// What signals do to a controller: Ctrl-C and others as a flag, so that it can end normally; the rest without effect.
#pragma once

#include <atomic>

namespace darwinop::webots_api {

/// Becomes true with the first signal of kEndSignals after installStopSignals().
const std::atomic<bool>& stopRequested();

/// The first signal of kEndSignals sets the flag; a second SIGINT, SIGTERM or SIGQUIT, from 0.3 s after the first, ends
/// the program at once. A signal that the program's parent chose to ignore stays ignored. The signals of
/// kIgnoredSignals no longer end or stop the program, unless it has a handler of its own for them: output into a pipe
/// that nobody reads any more, as in `| head -3`, and Ctrl-Z, which would stop the loop with the joints under torque.
void installStopSignals();

}  // namespace darwinop::webots_api
