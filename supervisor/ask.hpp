// Operator commands to a running supervisor: status, stop, stop or restart of the controller.
#pragma once

#include "runtime/clock.hpp"
#include "runtime/names.hpp"

namespace darwinop::supervisor {

// Each prints its result and returns the exit status for the shell. Throws std::runtime_error with a remedy.

/// 0: a supervisor runs, 1: none.
int printStatus(const runtime::RuntimeFiles& files);
/// Returns when the supervisor and all its child processes have ended. 0: the last supervisor has recorded that the
/// robot is at rest, or none has run since the computer was started; 1: it has not, and joints may be under torque.
int stopSupervisor(const runtime::RuntimeFiles& files);
/// The same on another clock.
int stopSupervisor(const runtime::RuntimeFiles& files, runtime::Clock& clock);
/// Returns when the default controller has ended. 0 also if it had already ended; 1: no supervisor runs.
int stopController(const runtime::RuntimeFiles& files);
/// Returns when the supervisor has taken the command. 1: no supervisor runs.
int restartController(const runtime::RuntimeFiles& files);

}  // namespace darwinop::supervisor
