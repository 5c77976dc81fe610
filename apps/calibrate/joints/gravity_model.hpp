// Torque that gravity demands of each servo, by the link masses of a twin model.
#pragma once

#include <array>
#include <memory>

#include "core/joints.hpp"
#include "twin/model/model.hpp"

namespace darwinop::calibrate {

using JointValues = std::array<double, kJoints>;

class GravityModel {
 public:
  /// Effects of the model are not applied. Throws std::runtime_error.
  explicit GravityModel(const twin::Model& model);
  ~GravityModel();
  GravityModel(const GravityModel&) = delete;
  GravityModel& operator=(const GravityModel&) = delete;

  /// N m, to hold a robot with a clamped trunk at rest at these joint angles (rad). `up`: left, up, forward of the
  /// trunk.
  [[nodiscard]] JointValues holdingTorques(const JointValues& angles_rad, const std::array<double, 3>& up);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace darwinop::calibrate
