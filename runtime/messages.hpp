// Message texts, or the parts that identify them. Sorted by the file that uses them.
#pragma once

namespace darwinop::runtime::messages {

// controller_run.cpp
inline constexpr const char* kNoSuchController = "there is no controller ";  // then its path
inline constexpr const char* kBuiltIn = "; name the one that was built: ";   // then its path
inline constexpr const char* kBuildFirst = "; build it first (make, or ./dev build)";
inline constexpr const char* kNameScript = "; name the script: ";                 // then those in the folder
inline constexpr const char* kNotAProgram = " is not a program that may be run";  // after its path
inline constexpr const char* kNoLoopLeft =
    "no loop is left: these joints may keep torque and their last goals: ";  // then their names

// daemon.cpp
inline constexpr const char* kNoMarkers = "a release by a person could not be recorded in ";  // then the files

// apps/runtime.cpp, supervisor
inline constexpr const char* kUnderTorque =
    "hold the robot and press RESET on its back; these joints may be under torque: ";  // then their names
inline constexpr const char* kAllJoints = "all joints";

// daemon_link.cpp: why the loop has ended
inline constexpr const char* kRuntimeEnds = "the runtime was requested to end; start it again with: darwinop runtime";
inline constexpr const char* kRobotReleased =
    "an operator has released the robot: torque is off; start the controller again to take over";
inline constexpr const char* kRuntimeDied =  // after the pid
    ") has died; the robot keeps its last goals and is not monitored: hold it. A supervisor brings it to rest; without "
    "one, start a runtime again: darwinop runtime";

// exchange.cpp
inline constexpr const char* kNoRuntime = "no runtime has been started here (";  // then the file
inline constexpr const char* kStartRuntime = "start one with: darwinop runtime";
inline constexpr const char* kOtherUsersRuntime = "a runtime of another user runs (";
inline constexpr const char* kTakesNoCommands = "the loop takes no commands from other programs (";
inline constexpr const char* kOtherVersion = " was made by another version of the runtime";  // after the file
inline constexpr const char* kNotOneRuntime = " do not belong together";                     // after both files

// marker_file.cpp
inline constexpr const char* kMarkerOfOthers = " was not made by this runtime but by ";  // after the path
inline constexpr const char* kMarkerCountsAsSet =
    "; what an earlier loop recorded there is unknown, so the robot counts as released: it stays limp until START is "
    "pressed, a controller is started, or: darwinop runtime --reset-faults";
inline constexpr const char* kMarkerReplaced = ". It was replaced";
inline constexpr const char* kRemoveMarker = ". Remove it: sudo rm -r ";  // then the path

// operator.cpp
inline constexpr const char* kRuntimeHasEnded = ") has ended; start it again with: darwinop runtime";  // after the pid
inline constexpr const char* kLoopHangs =                                                              // after the pid
    ") has not run a cycle for 3 s, so nothing is known of the robot; restart it";
inline constexpr const char* kCausesPersist =
    "faults whose cause persists stay latched; remove it, then reset them again:";  // then the faults, a line each
inline constexpr const char* kNotReleased =
    ") has not released the robot within 3 s: hold it and press RESET on its back";  // after the pid
inline constexpr const char* kReleasedInSilence =
    "the board does not answer, so torque could not be switched off: hold the robot and press RESET on its back, or "
    "expect it to drop when the board answers again";

// python_command.cpp
inline constexpr const char* kNoPythonModules = "this build has no Python modules: there is no ";  // then the folder
inline constexpr const char* kNoPython = "no Python loads the modules in ";                        // then the folder

// recorder.cpp
inline constexpr const char* kRowsLost = " rows: the disk was too slow; record to another one";  // after their number

// recording_file.cpp
inline constexpr const char* kRecordingExists = " exists; give another file with --record";  // after the path
inline constexpr const char* kNotARecording =
    " is not a recording, so it is not replaced; choose another file with --record";  // after the path

// report.cpp
inline constexpr const char* kNoBoard = "board         none: servo power is unknown; no buttons, no inertial sensor\n";
inline constexpr const char* kNoCycle = "The loop has not run a cycle.\n";

// shared_file.cpp: why a file is not used
inline constexpr const char* kNotARegularFile = "it is not a regular file";
inline constexpr const char* kSeveralNames = "it has more than one name";
inline constexpr const char* kEveryUserMayWrite = "every user may write it";
inline constexpr const char* kOwnerNotTrusted = "who is not trusted here";

}  // namespace darwinop::runtime::messages
