// What a person may ask of a supervisor that runs: status, stop, the controller's stop and restart.
#pragma once

#include "runtime/names.hpp"

namespace darwinop::supervisor {

// Each prints what it found and returns the exit status for the shell. Throws std::runtime_error with what to do.

/// 0: a supervisor runs, 1: none.
int printStatus(const runtime::RuntimeFiles& files);
/// Returns when the supervisor and all that it started have ended. 0 also when none runs.
int stopSupervisor(const runtime::RuntimeFiles& files);
/// Returns when the default controller has ended. 0 also when it had ended before; 1: no supervisor runs.
int stopController(const runtime::RuntimeFiles& files);
/// Returns when the supervisor has taken the order. 1: no supervisor runs.
int restartController(const runtime::RuntimeFiles& files);

}  // namespace darwinop::supervisor
