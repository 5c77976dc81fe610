// Message texts, or the parts that identify them.
#pragma once

namespace darwinop::calibrate::messages {

// After the name of a posture.
inline constexpr const char* kMoved = ": the robot moved; support it so that it rests, and repeat";
inline constexpr const char* kAnotherPosture = ": the accelerometer shows another posture; read the instruction again";

// After the name of a joint.
inline constexpr const char* kServoIsSilent = ": the servo does not answer; check it with darwinop doctor";
inline constexpr const char* kUnderTorque = ": it is under torque; make it limp (RESET on the back) and repeat";
inline constexpr const char* kJointMoved = ": it moved; hold it still and repeat";
inline constexpr const char* kHornIsFarOff = "   not written: more than 0.2 rad off, remount the horn by a tooth";
inline constexpr const char* kNoSuchJoint = ": no joint has this name; joints are called as in Webots, e.g. Neck";

inline constexpr const char* kNoReadings = "the board does not answer; check it with darwinop doctor. ";
inline constexpr const char* kNoImu =
    "without a board this robot has no gyroscope and no accelerometer; zero offsets: darwinop calibrate by-hand";
inline constexpr const char* kTooFewPostures =
    "these postures do not separate bias, scale and mounting; nothing is written. Repeat with all six postures";
inline constexpr const char* kRuntimeRunsHere = "a runtime is running here (pid ";
inline constexpr const char* kOtherLoop =
    ": the loop of this robot runs elsewhere and reads its own robot.ini; stop the runtime and name the serial port, "
    "on the robot's computer or with the CM-730's USB cable in this one";
inline constexpr const char* kNothingToCalibrate =
    "--robot virtual: its joints cannot be turned by hand, so there is nothing to calibrate; try it with --robot twin "
    "--file FILE";
inline constexpr const char* kNoSuchRobotFile =
    " does not exist: limits, absent joints and offsets of the robot would not apply. Copy its file first: ";
inline constexpr const char* kNeedsHands = "--yes is for twins: a person has to hold this robot in each posture";
inline constexpr const char* kYesByHand = "by-hand asks for each joint: leave --yes out";
inline constexpr const char* kNoJointRead = "no joint was read; nothing written";
inline constexpr const char* kNotDriven = "the robot does not let itself be driven; check it with darwinop doctor";
inline constexpr const char* kStopped = "stopped; nothing was written";
inline constexpr const char* kNothingWritten = "nothing written";

}  // namespace darwinop::calibrate::messages
