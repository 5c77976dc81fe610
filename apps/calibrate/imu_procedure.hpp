// Reads the inertial sensors in every posture. Nothing moves: no command is ever published.
#pragma once

#include <atomic>
#include <iosfwd>
#include <vector>

#include "apps/calibrate/imu_fit.hpp"
#include "apps/calibrate/stand.hpp"
#include "runtime/robot_link.hpp"

namespace darwinop::calibrate {

/// `corrected_by`: the calibration that the readings of `link` have. A posture in which the robot moves, or is not as
/// asked, is asked for again, three times at most. Throws std::runtime_error if the robot has no board or stops
/// answering.
std::vector<PostureReading> readPostures(runtime::RobotLink& link, Stand& stand,
                                         const cm730::ImuCalibration& corrected_by, Nanos time,
                                         const std::atomic<bool>& stop, std::ostream& log);

}  // namespace darwinop::calibrate
