// Webots: P, I and D of the error set a speed, which is limited, and then how fast it changes. ODE's motor reaches that
// speed within one step, if maxTorque lets it. Damping and friction are ODE's too: damping is implicit; the motor and
// the static friction are one constraint, which has the greater torque of the two.
#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/export/bodies.hpp"
#include "gap/export/fields.hpp"
#include "gap/export/joints.hpp"

namespace darwinop::gap {
namespace {

constexpr double kGearKgm2 = 4e-9;  // of the body within the gap, as in the model of the robot's successor
constexpr double kErp = 0.2;        // ODE: share of a stop's overlap that one step takes back

class WebotsJoint final : public TargetJoint {
 public:
  WebotsJoint(const ServoNumbers& servo, const ArmNumbers& arm, double step_s)
      : f_{webotsFields(servo)},
        arm_{arm},
        h_{step_s},
        arm_kgm2_{std::max(arm.inertia_kgm2 + servo.armature_kgm2, kLightestLink)} {}

  void reset(double position_rad) override {
    q_ = {position_rad, position_rad};
    w_ = {};
    speed_ = integral_ = last_error_ = 0;
  }

  void step(bool torque_on, double goal_rad) override {
    const double wanted = torque_on ? motorSpeed(goal_rad - q_.gear) : limp();
    const double most = torque_on ? std::max(f_.static_friction, f_.max_torque) : f_.static_friction;
    const double gravity = arm_.gravityAt(q_.arm);
    const bool gap = f_.gap > 0;
    const double rigid_kgm2 = gap ? kGearKgm2 : arm_kgm2_;
    const double braked_kgm2 = rigid_kgm2 + h_ * f_.damping_constant;  // implicit damping
    const Pair mobility{h_ / braked_kgm2, gap ? h_ / arm_kgm2_ : 0};
    const Pair free{(rigid_kgm2 * w_.gear + (gap ? 0 : h_ * gravity)) / braked_kgm2, w_.arm + h_ * gravity / arm_kgm2_};

    Constraint rows[2]{{.direction = {1, 0}, .wanted = wanted, .low = -most, .high = most}, {}};
    const bool stops = gap && touch(rows[1]);
    const auto torque = solveConstraints({rows, stops ? 2u : 1u}, mobility, free);
    w_.gear = free.gear + mobility.gear * (torque[0] + torque[1] * rows[1].direction.gear);
    w_.arm = gap ? free.arm + mobility.arm * torque[1] * rows[1].direction.arm : w_.gear;
    q_.gear += h_ * w_.gear;
    q_.arm = gap ? q_.arm + h_ * w_.arm : q_.gear;
  }

  [[nodiscard]] double position_rad() const override { return q_.gear; }  // the sensor sits on the motor's side
  [[nodiscard]] double velocity_rad_s() const override { return w_.gear; }

 private:
  double motorSpeed(double error) {
    integral_ += error * h_;
    const double derivative = (error - last_error_) / h_;
    last_error_ = error;
    const double law = f_.p * error + f_.i * integral_ + f_.d * derivative;
    const double wanted = std::clamp(law, -f_.max_velocity, f_.max_velocity);
    const double most = f_.acceleration < 0 ? std::numeric_limits<double>::infinity() : f_.acceleration * h_;
    return speed_ += std::clamp(wanted - speed_, -most, most);
  }

  double limp() {
    integral_ = last_error_ = 0;
    return speed_ = 0;
  }

  // A stop works from the step on in which it is passed.
  bool touch(Constraint& row) const {
    const double twist = q_.arm - q_.gear, most = std::numeric_limits<double>::infinity();
    if (twist < -f_.gap / 2)
      row = {.direction = {-1, 1}, .wanted = kErp * (-f_.gap / 2 - twist) / h_, .low = 0, .high = most};
    else if (twist > f_.gap / 2)
      row = {.direction = {1, -1}, .wanted = kErp * (twist - f_.gap / 2) / h_, .low = 0, .high = most};
    else
      return false;
    return true;
  }

  WebotsFields f_;
  ArmNumbers arm_;
  double h_, arm_kgm2_;
  Pair q_, w_;
  double speed_ = 0, integral_ = 0, last_error_ = 0;
};

}  // namespace

std::unique_ptr<TargetJoint> webotsJoint(const ServoNumbers& servo, const ArmNumbers& arm, double step_s) {
  return std::make_unique<WebotsJoint>(servo, arm, step_s);
}

}  // namespace darwinop::gap
