// What a person may ask of a running daemon without driving the robot.
#pragma once

#include <string>

#include "runtime/exchange.hpp"
#include "runtime/names.hpp"
#include "safety/start_pose.hpp"

namespace darwinop::runtime {

/// Attaches to a daemon that lives. Throws std::runtime_error with what to do.
Exchange attachToDaemon(const RuntimeFiles& files);
/// The same, and nothing can be written there.
Exchange observeDaemon(const RuntimeFiles& files);

/// State, faults and what to do about them, battery, who drives, loop figures.
std::string daemonStatus(const RuntimeFiles& files);

/// Latched faults are forgotten; the servos that shut themselves off may be driven again.
void resetFaults(const RuntimeFiles& files);

/// Torque off on every joint, now, in any session: hold the robot. The controller is requested to end. Torque stays off
/// until a person resets the fault or starts a controller.
void releaseRobot(const RuntimeFiles& files);

/// Where the robot is now, judged by a cycle that ends after the call. Throws std::runtime_error when none does.
safety::StartPoseCheck startPoseNow(const RuntimeFiles& files);

}  // namespace darwinop::runtime
