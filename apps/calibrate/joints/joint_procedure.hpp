// Sweeps the joints in every posture of the clamped trunk.
#pragma once

#include <atomic>
#include <bitset>
#include <iosfwd>
#include <vector>

#include "apps/calibrate/joints/sweep.hpp"
#include "apps/calibrate/stand.hpp"
#include "runtime/robot_link.hpp"

namespace darwinop::calibrate {

/// `absent`: joints that the robot lacks. Ends the session with torque off. Empty after a stop request, or if no
/// posture was held. Throws std::runtime_error if the robot stops answering.
std::vector<GravityPoint> sweepJoints(std::unique_ptr<runtime::RobotLink> link, Stand& stand,
                                      const std::bitset<kJoints>& absent, const std::atomic<bool>& stop,
                                      std::ostream& log);

}  // namespace darwinop::calibrate
