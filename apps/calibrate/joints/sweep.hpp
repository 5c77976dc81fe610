// Sweeps joints slowly there and back and averages their duty, so that friction cancels and gravity remains.
#pragma once

#include <atomic>
#include <bitset>
#include <vector>

#include "apps/calibrate/joints/sweep_plan.hpp"
#include "runtime/driver_session.hpp"

namespace darwinop::calibrate {

/// Duty of one joint at one angle, mean of both directions.
struct GravityPoint {
  Joint joint;
  JointValues angles_rad;  // of all joints, as they read
  double load, sigma;      // fraction of full duty, which is the maximum torque at rest
  std::array<double, 3> up;
};

/// Drives a robot whose trunk is clamped. Every command passes through the safety layer.
class Sweeper {
 public:
  /// Takes over where the joints are. Joints of `left_out` are not driven. Throws std::runtime_error if the robot does
  /// not let itself be driven.
  Sweeper(runtime::DriverSession& session, const std::bitset<kJoints>& left_out, const std::atomic<bool>& stop);

  void moveTo(const JointValues& pose);
  /// Sweeps these joints at the same time, each about its angle in the base pose.
  [[nodiscard]] std::vector<GravityPoint> sweep(const std::bitset<kJoints>& joints, const std::array<double, 3>& up);
  /// Torque off, so that the owner can turn the robot. Ends the session.
  void release();

 private:
  Sensors step();

  runtime::DriverSession& session_;
  std::bitset<kJoints> driven_;
  const std::atomic<bool>& stop_;
  Commands commands_{};
  JointValues goal_{};
  int sweeps_ = 0;
};

}  // namespace darwinop::calibrate
