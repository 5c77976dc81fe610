// One joint as each target moves it, by the rules of that target's own manual.
#pragma once

#include <memory>

#include "gap/export/numbers.hpp"
#include "gap/export/target.hpp"

namespace darwinop::gap {

/// kg m2. Least inertia of a link: none cannot be simulated. The default rotor has 30 000 times this.
inline constexpr double kLightestLink = 1e-7;

class TargetJoint {
 public:
  virtual ~TargetJoint() = default;
  /// At rest there.
  virtual void reset(double position_rad) = 0;
  /// One time step of the target.
  virtual void step(bool torque_on, double goal_rad) = 0;
  /// By an encoder without quantisation.
  [[nodiscard]] virtual double position_rad() const = 0;
  [[nodiscard]] virtual double velocity_rad_s() const = 0;
};

std::unique_ptr<TargetJoint> webotsJoint(const ServoNumbers& servo, const ArmNumbers& arm, double step_s);
std::unique_ptr<TargetJoint> mujocoJoint(const ServoNumbers& servo, const ArmNumbers& arm, double step_s);
std::unique_ptr<TargetJoint> urdfJoint(const ServoNumbers& servo, const ArmNumbers& arm, double step_s);
std::unique_ptr<TargetJoint> jointOf(Target target, const ServoNumbers& servo, const ArmNumbers& arm, double step_s);

}  // namespace darwinop::gap
