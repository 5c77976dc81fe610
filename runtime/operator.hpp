// Operator commands to a running daemon, without the driving lease: status, reset faults, release.
#pragma once

#include <string>

#include "runtime/exchange.hpp"
#include "runtime/names.hpp"
#include "safety/start_pose.hpp"

namespace darwinop::runtime {

/// Attaches to a running daemon. Throws std::runtime_error with a remedy.
Exchange attachToDaemon(const RuntimeFiles& files);
/// The same with read access only.
Exchange observeDaemon(const RuntimeFiles& files);

/// Text for the user: state, faults with remedies, battery, driving controller, loop statistics.
std::string daemonStatus(const RuntimeFiles& files);

/// Clears latched faults; servos that shut themselves off may be driven again. Throws std::runtime_error with remedies
/// if faults remain because their causes do, or if the loop hangs.
void resetFaults(const RuntimeFiles& files);
/// The same without waiting for the loop.
void requestFaultReset(const RuntimeFiles& files);

/// Switches torque off on every joint at once, in any session; the robot may drop. The controller is requested to end.
/// Torque stays off until a person resets the fault or starts a controller. Throws std::runtime_error if the loop hangs
/// or the board is silent: torque then goes off when the board answers again.
void releaseRobot(const RuntimeFiles& files);

/// Checks the present pose in a cycle that ends after the call. Throws std::runtime_error if no cycle does.
safety::StartPoseCheck startPoseNow(const RuntimeFiles& files);

}  // namespace darwinop::runtime
