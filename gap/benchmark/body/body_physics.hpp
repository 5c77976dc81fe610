// Simulates recordings of a robot in which something is hidden: servos of the twin on a body whose contacts, dry
// friction and stops are springs and dampers, with a step of a quarter of a millisecond. Masses and geometry are those
// of the twin; solver, contact model, step and integrator are not.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "gap/localize/body/floor_residuals.hpp"

namespace darwinop::gap {

/// Something that no catalogue has.
struct Disturber {
  /// Torque on a joint, N m, from its true angle, rad.
  std::optional<Joint> joint;
  std::function<double(double angle_rad)> torque_nm;
  /// Force on the trunk, N, in the world's frame, in one log.
  std::string file;
  double from_s = 0, to_s = 0;
  Eigen::Vector3d push_n = Eigen::Vector3d::Zero();
};

/// The robot as it is.
struct BodyTruth {
  FloorModel model;
  double battery_ohm = 0;  // of the battery that all servos share
  std::optional<Disturber> outside;
  std::optional<LinkChange> loose;  // from loose_from_s of the session on
  double loose_from_s = 0;
};

/// Fills the measured columns of one log of `plan`; `noise` null: without noise and rounding. Returns whether the robot
/// fell.
bool measureBody(BodyCase& plan, std::size_t log, const BodyTruth& truth, const Disturbance* noise);

}  // namespace darwinop::gap
