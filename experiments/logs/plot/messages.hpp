// Labels of figures and phrases of errors that identify them.
#pragma once

namespace darwinop::plot::messages {

// labels of an experiment's own plot
inline constexpr const char* kAngleFalling = "angle falling";
inline constexpr const char* kAngleRising = "angle rising";
inline constexpr const char* kAnkleAngle = "angle of the ankle [rad]";
inline constexpr const char* kSpeedSetting = "speed setting [rad/s]";
inline constexpr const char* kSweepTimes = "time per sweep over the speed setting";
inline constexpr const char* kTimeSinceRelease = "time since release [s]";

// title of the panel of columns without a unit
inline constexpr const char* kNoUnit = "plain numbers";

// errors
inline constexpr const char* kGnuplotMissing = "gnuplot is not installed (apt-get install gnuplot-nox)";
inline constexpr const char* kNothingMoves = "no joint moves and no sensor changes";

}  // namespace darwinop::plot::messages
