// Virtual robot in this process and in simulated time: board, body, line and bus in memory.
#pragma once

#include <memory>

#include "hal/body.hpp"
#include "hal/cm730/imu_correction.hpp"
#include "hal/cm730/joint_offsets.hpp"
#include "runtime/lockstep_link.hpp"

namespace darwinop::connect {

/// [Offsets] and [Imu] of a robot.ini. Simulated robots have none, except while they are calibrated.
struct Calibration {
  cm730::JointOffsets offsets{};
  cm730::ImuCalibration imu{};
};

/// Uses the same bus code and bytes as a robot. Bit-exact reproducible. Without a body the joints are motors without
/// physics. `config.port`: the robot's description in recordings.
std::unique_ptr<runtime::RobotLink> lockstepRobot(const runtime::LoopConfig& config,
                                                  std::unique_ptr<Body> body = nullptr,
                                                  const Calibration& calibration = {});

}  // namespace darwinop::connect
