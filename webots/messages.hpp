// Message texts, or the parts that identify them.
#pragma once

namespace darwinop::webots_api::messages {

inline constexpr const char* kSecondRobot = "a second Robot was made in this program: there can be one only";
inline constexpr const char* kAskedToEnd = "asked to end before the robot was ready";

// After the call that asked for a device which this robot does not have.
inline constexpr const char* kNoSuchDevice = ": this robot has no such device; it returns NULL";
// After a device that a controller makes by name, of a class that this robot has no device of.
inline constexpr const char* kAbsentDevice =
    ": this robot has no such device; its calls have no effect, its values are NaN or NULL, its counts 0";
// After a device that a controller makes by name.
inline constexpr const char* kNoDeviceToMake =
    ": this robot has no such device; make one of a name that getDevice() finds";
inline constexpr const char* kNoRobotYet = ": make the Robot first; a device belongs to it";
// Calls that exist in simulation only.
inline constexpr const char* kNoJoystick = "Joystick: this robot reads no joystick: it is never connected";
inline constexpr const char* kNoMouse = "Mouse: this robot reads no mouse: it is never in the window";
inline constexpr const char* kNoRecognition =
    "Camera: recognition of objects exists in simulation only: no object is ever recognised";
inline constexpr const char* kNoSceneTree = ": a robot has no scene tree and no simulation; the call has no effect";
inline constexpr const char* kNoThreeAxes = "TouchSensor::getValues() returns NULL: a button has one value";
inline constexpr const char* kKeyboardWithoutRobot =
    "Keyboard: make the Robot first: without it no key is ever pressed";

// At the end of a session that the user ended, by [Safety] on_exit.
inline constexpr const char* kEndsHolding = "ending: the robot holds its pose; its joints stay under torque";
inline constexpr const char* kEndsKneeling =
    "ending: the robot sits down and releases torque; a second Ctrl-C would leave its joints under torque";
inline constexpr const char* kEndsLimp =
    "ending: the robot releases torque; a second Ctrl-C would leave its joints under torque";

// Motion files, after "FILE:2".
inline constexpr const char* kNoPose = ": it has no pose";

/// After an entry of [Offset] in config.ini; then what replaces it.
inline constexpr const char* kOffsetsAreTheRobots = " has no effect; put into [Offsets] of robot.ini: ";

}  // namespace darwinop::webots_api::messages
