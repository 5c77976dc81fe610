// Operator commands to the running supervisor. Sent as signals: no socket, no thread, no queue.
#pragma once

#include <csignal>

namespace darwinop::supervisor {

inline constexpr int kStopControllerSignal = SIGUSR1, kRestartControllerSignal = SIGUSR2;

struct Orders {
  bool stop = false;                // any of kEndSignals
  bool stop_controller = false;     // SIGUSR1
  bool restart_controller = false;  // SIGUSR2
};

/// Installs the signal handlers.
void listenForOrders();
/// Commands since the last call. Of stop-controller and restart-controller only the last one is set.
Orders takeOrders();

}  // namespace darwinop::supervisor
