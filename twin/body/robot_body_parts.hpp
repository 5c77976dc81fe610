// The simulation behind RobotBody: MuJoCo's model and state, servos, sensors.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "twin/body/imu.hpp"
#include "twin/body/joint_torques.hpp"
#include "twin/body/mujoco_model.hpp"
#include "twin/body/robot_body.hpp"

namespace darwinop::twin {

struct RobotBody::Parts {
  Parts(const Model& requested, const RobotBodyOptions& options);

  void physicsStep(const Drives& drives) noexcept;
  void sagBattery() noexcept;
  void placeAt(const std::array<double, kJoints>& angles_rad, double lean_rad, double settle_s = 0);
  bool clampAt(const ClampedUp& up) noexcept;
  void publish() noexcept;
  void checkWarnings() noexcept;
  void stopSimulation(const char* why) noexcept;

  std::vector<Servo> servos;
  Model model;
  MjModelPtr m;
  BodyMap map;
  JointTorques torques;
  MjDataPtr d;
  Imu imu;
  std::optional<ClampedUp> clamped_up;
  bool ball_circles;
  std::int64_t step_ns, firmware_ns;
  std::int64_t now_ns = 0, next_firmware_ns = 0, pending_ns = 0, push_until_ns = 0;
  std::uint64_t samples = 0;
  double battery_drop_v = 0;
  BodyState state;
  std::array<char, 400> error{};
};

}  // namespace darwinop::twin
