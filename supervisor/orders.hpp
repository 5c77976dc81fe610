// What a person asked of the running supervisor. Orders are signals: no socket, no thread, nothing that can be full.
#pragma once

#include <csignal>

namespace darwinop::supervisor {

inline constexpr int kStopControllerSignal = SIGUSR1, kRestartControllerSignal = SIGUSR2;

struct Orders {
  bool stop = false;                // any of kEndSignals
  bool stop_controller = false;     // SIGUSR1
  bool restart_controller = false;  // SIGUSR2
};

/// From here on signals become orders.
void listenForOrders();
/// Those that came since the last call. Of stop-controller and restart-controller the one that came last counts.
Orders takeOrders();

}  // namespace darwinop::supervisor
