// Simulates the whole robot on the floor: its servos follow the recorded goals. Body, contacts and servos are those of
// the twin.
#pragma once

#include <array>
#include <memory>

#include "gap/plant/body/limb_roll_out.hpp"

namespace darwinop::gap {

/// What a hypothesis changes in trunk and floor; the defaults change nothing.
struct FloorChange {
  double friction_factor = 1, contact_time_factor = 1;  // of the model's numbers
  /// rad. The floor is turned about the world's x (forward), then y (left).
  std::array<double, 2> tilt_rad{};
  double sole_scale = 1;     // length and width of both soles
  double trunk_mass_kg = 0;  // added, at this distance from the centre of mass
  Eigen::Vector3d trunk_from_com_m = Eigen::Vector3d::Zero(), trunk_com_shift_m = Eigen::Vector3d::Zero();
};

/// How another physics engine may solve the same model. The defaults are those of the twin.
struct PhysicsEngine {
  bool pyramidal_friction = false;  // cone of the contact friction
  double impedance = 1;             // factor on the distance of the contacts' impedance from 1
  int step_divisor = 1;             // of the twin's step
  double drop_m = 0;                // the robot is put down from this height
};

struct FloorHypothesis {
  BodyHypothesis robot;
  FloorChange floor;
  PhysicsEngine engine = {};
};

/// Of each row, the encoder's position in the last firmware cycle before it; rows x joints of the robot. After
/// each cycle, the signals of the inertial sensors that tracedSensors returns (moving_imu.hpp); cycles x 3.
struct FloorTrace {
  Eigen::MatrixXd position_rad;
  Eigen::MatrixX3d gyro_rad_s, accel_m_s2;
  std::vector<Eigen::Index> cycle_of_row;  // rows of the two above, at the time of a row of the log
};

/// `log`: setup floor or lying, law voltage_p. NaN from where the simulation has failed. Deterministic, thread-safe.
/// `noise`: as that of a bench, other for each joint.
FloorTrace rollOut(const BodyCase& given, std::size_t log, const FloorHypothesis& hypothesis,
                   const Disturbance* noise = nullptr);

}  // namespace darwinop::gap
