// Message texts, or the parts that identify them.
#pragma once

namespace darwinop::webots_api::messages {

inline constexpr const char* kSecondRobot = "a second Robot was made in this program: there can be one only";
inline constexpr const char* kAskedToEnd = "asked to end before the robot was ready";

// At the end of a session that the user ended, by [Safety] on_exit.
inline constexpr const char* kEndsHolding = "ending: the robot holds its pose; its joints stay under torque";
inline constexpr const char* kEndsKneeling =
    "ending: the robot sits down and releases torque; a second Ctrl-C would leave its joints under torque";
inline constexpr const char* kEndsLimp =
    "ending: the robot releases torque; a second Ctrl-C would leave its joints under torque";

// Motion files, after "FILE:2".
inline constexpr const char* kNoPose = ": it has no pose";

}  // namespace darwinop::webots_api::messages
