// Phrases by which the supervisor's messages are recognized. Sorted by the file that uses them.
#pragma once

namespace darwinop::supervisor::messages {

// ask.cpp
inline constexpr const char* kEndedBefore = "the supervisor has ended before it took the command";
inline constexpr const char* kNoSupervisor = "no supervisor runs";
inline constexpr const char* kNoRecordOfRest =  // then the file
    "the last supervisor has not recorded that the robot is at rest: it was killed (its runtime then brings the robot "
    "to "
    "rest), or its file could not be written. Watch the robot until it sits, and hold it if it stands; file: ";

// default_controller.cpp: after the controller's name
inline constexpr const char* kEndedByItself = " has ended by itself";
inline constexpr const char* kFailed = " has failed: ";   // then the number of crashes; the robot is held
inline constexpr const char* kKilled = " and is killed";  // it did not end in time
inline constexpr const char* kStopped = " stopped";

// default_controller_start.cpp
inline constexpr const char* kWaitingForPose = "waiting for the start pose";
inline constexpr const char* kWaitingForUser = "waiting for user action: ";  // then the fault's meaning
inline constexpr const char* kHowToReset = "press START, or run: darwinop runtime --reset-faults";
inline constexpr const char* kNotStarted = " not started: ";  // after the controller's name, before the reason

// default_controller.cpp: before the pid, and before what the attempt to take the lease reports
inline constexpr const char* kOtherDrives = "cannot hold the robot, which another controller has: ";
inline constexpr const char* kCannotHold = "cannot hold the robot yet: ";

// rescue.cpp: after the port
inline constexpr const char* kUnplugged =
    " is not the robot's USB adapter any more: plug its cable into the same socket as before";

// supervisor.cpp, supervisor_runtime.cpp
inline constexpr const char* kAfterKill =
    "not started: the last supervisor was killed or did not bring the robot to rest; start it with: darwinop "
    "supervisor "
    "--restart-controller";
inline constexpr const char* kStaysEnded =
    "not started: it was stopped or had ended; it starts at the next boot, or with: darwinop supervisor "
    "--restart-controller";
inline constexpr const char* kRuntimeReady = "runtime: ready";
inline constexpr const char* kRescues = "; bringing the robot to rest: ";                       // then the steps
inline constexpr const char* kCannotReachRobot = "rescue: cannot reach the robot, retrying: ";  // then the reason
inline constexpr const char* kRescued = "rescue: the robot is at rest, torque is off";
inline constexpr const char* kEnded = "ended";  // then the next one, or "; " and runtime::messages::kUnderTorque
inline constexpr const char* kAtRest = "; the robot is at rest";

}  // namespace darwinop::supervisor::messages
