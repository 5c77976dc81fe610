// Message texts, or the parts that identify them.
#pragma once

namespace darwinop::connect::messages {

// robot.ini.
inline constexpr const char* kHasNoBoard = ", no board";
inline constexpr const char* kNoRobotFile = "no robot.ini: port, limits and offsets are as on a stock robot";
inline constexpr const char* kCopyRobotFile = "scp darwin@192.168.123.1:/opt/darwinop/robot.ini ";  // then where to
inline constexpr const char* kNoJointLeft = "a robot without any joint cannot be driven";
inline constexpr const char* kNoSuchServoModel = "give models with commas between, or nothing; there are ";
inline constexpr const char* kNoSuchImuKey = "no such key; there are gyro_bias, accel_bias, accel_scale and mounting";
inline constexpr const char* kImuIsCalibrated = ", inertial sensor calibrated";
inline constexpr const char* kGivenTwice = " is there a second time; keep one of the two";  // after the key

// Start-up check; after the port, before the findings.
inline constexpr const char* kCannotBeDriven = " cannot be driven:\n";

// connect.cpp; after the controller's file.
inline constexpr const char* kNoSafetyOverTcp = ": [Safety] and [Limits] do not reach a robot over TCP";

// Camera; followed by the reason.
inline constexpr const char* kNoPicturesForObservers =
    "observers of darwinop monitor see no pictures while this drives: ";

}  // namespace darwinop::connect::messages
