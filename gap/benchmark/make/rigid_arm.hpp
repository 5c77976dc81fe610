// A pendulum on a servo, integrated in another way and with another step than the bench that the finder uses: the
// midpoint rule at 0.1 ms, dry friction as the torque that would stop the joint, clipped. That the two agree on a case
// without any effect says something then.
#pragma once

#include <memory>
#include <vector>

#include "twin/bench/bench.hpp"

namespace darwinop::gap {

/// Has the part of twin::Bench's face that a hider needs. For a gear that is rigid.
class RigidArm {
 public:
  /// Throws std::runtime_error when nothing has inertia.
  RigidArm(const twin::ServoParameters& parameters, std::vector<std::unique_ptr<twin::Effect>> effects,
           const twin::Pendulum& pendulum);

  void reset(const twin::BenchOptions& options);
  /// One firmware period.
  void step(const ServoDrive& drive) noexcept;

  [[nodiscard]] double encoder_rad() const noexcept { return position_; }
  [[nodiscard]] double velocity_rad_s() const noexcept { return velocity_; }
  [[nodiscard]] const twin::Servo& servo() const noexcept { return servo_; }

 private:
  void advance(double dt_s) noexcept;
  void follow(const twin::Actuation& servo, double outside_nm, double dt_s) noexcept;
  [[nodiscard]] double gravityAt(double position_rad) const noexcept;

  twin::Servo servo_;
  double inertia_kgm2_ = 0, weight_nm_ = 0, hangs_at_rad_ = 0;
  double position_ = 0, velocity_ = 0;
};

}  // namespace darwinop::gap
