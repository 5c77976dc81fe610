// Signal handling of controllers: Ctrl-C and others set a flag, so that the controller can end normally; the rest are
// ignored.
#pragma once

#include <atomic>

namespace darwinop::webots_api {

/// True after the first signal of kEndSignals since installStopSignals().
const std::atomic<bool>& stopRequested();

/// The first signal of kEndSignals sets the flag; a second SIGINT, SIGTERM or SIGQUIT more than 0.3 s later ends the
/// program at once. Signals that the parent process ignored stay ignored. Signals of kIgnoredSignals are ignored unless
/// the program has its own handler: for example SIGPIPE, of a closed pipe as in `| head -3`, and SIGTSTP, of Ctrl-Z,
/// which would stop the loop with the joints under torque.
void installStopSignals();

}  // namespace darwinop::webots_api
