// MuJoCo: semi-implicit Euler with implicit joint damping; actuators are explicit. Dry friction and stops are soft
// constraints of its convex model: force = -(a - a_ref) / R, within bounds, R = (1 - d) / d * 1/m.
#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/export/bodies.hpp"
#include "gap/export/fields.hpp"
#include "gap/export/joints.hpp"

namespace darwinop::gap {
namespace {

class MujocoJoint final : public TargetJoint {
 public:
  MujocoJoint(const ServoNumbers& servo, const ArmNumbers& arm, double step_s)
      : f_{mujocoFields(servo, arm.inertia_kgm2, step_s)},
        arm_{arm},
        soft_{f_.twoHinges()},
        arm_kgm2_{std::max(arm.inertia_kgm2, kLightestLink)},
        gear_kgm2_{soft_ ? f_.armature : f_.armature + arm_kgm2_} {}

  void reset(double position_rad) override {
    q_ = {position_rad, position_rad};
    w_ = {};
  }

  void step(bool torque_on, double goal_rad) override {
    const double spring = soft_ ? f_.stiffness * (q_.gear - q_.arm) + f_.flex_damping * (w_.gear - w_.arm) : 0;
    const double gravity = arm_.gravityAt(q_.arm);
    Pair torque{(torque_on ? actuator(goal_rad) : 0) - f_.damping * w_.gear - spring, gravity + spring};
    if (!soft_) torque.gear += gravity;

    const Pair mobility{1 / gear_kgm2_, soft_ ? 1 / arm_kgm2_ : 0};
    const Pair free{torque.gear * mobility.gear, torque.arm * mobility.arm};
    Constraint rows[2];
    std::size_t count = 0;
    if (f_.frictionloss > 0) rows[count++] = friction();
    if (stop(rows[count])) ++count;
    const auto force = solveConstraints({rows, count}, mobility, free);
    for (std::size_t i = 0; i < count; ++i) {
      torque.gear += rows[i].direction.gear * force[i];
      torque.arm += rows[i].direction.arm * force[i];
    }
    move(torque);
  }

  // The servo's encoder sits behind the play and before a spring.
  [[nodiscard]] double position_rad() const override { return f_.play > 0 ? q_.arm : q_.gear; }
  [[nodiscard]] double velocity_rad_s() const override { return f_.play > 0 ? w_.arm : w_.gear; }

 private:
  [[nodiscard]] double actuator(double goal_rad) const {
    const double push = f_.gain * goal_rad - f_.kp * q_.gear - f_.kd * w_.gear;
    return std::clamp(push, -f_.force, f_.force) - f_.back_emf * w_.gear;
  }

  // As MuJoCo makes its reference from a time constant and a damping ratio of 1.
  [[nodiscard]] double referenceDamping(double impedance) const { return 2 / (impedance * f_.hardTime()); }
  [[nodiscard]] double referenceStiffness(double impedance) const {
    const double time = impedance * f_.hardTime();
    return 1 / (time * time);
  }

  [[nodiscard]] Constraint friction() const {
    return {.direction = {1, 0},
            .wanted = -referenceDamping(kFrictionImpedance) * w_.gear,
            .low = -f_.frictionloss,
            .high = f_.frictionloss,
            .softness = (1 - kFrictionImpedance) / kFrictionImpedance / gear_kgm2_};
  }

  bool stop(Constraint& row) const {
    if (f_.play <= 0) return false;
    const double twist = q_.arm - q_.gear;
    const double side = twist < 0 ? 1 : -1;  // where the stop pushes the arm
    const double distance = f_.play / 2 - std::abs(twist);
    if (distance >= 0) return false;
    const double speed = side * (w_.arm - w_.gear), d = kStopImpedance;
    row = {.direction = {-side, side},
           .wanted = -referenceDamping(d) * speed - referenceStiffness(d) * d * distance,
           .low = 0,
           .high = std::numeric_limits<double>::infinity(),
           .softness = (1 - d) / d * (1 / gear_kgm2_ + 1 / arm_kgm2_)};
    return true;
  }

  // (M + h D) a = torque: D brakes the gear side, and what moves between gear and arm.
  void move(const Pair& torque) {
    const double h = f_.timestep, between = soft_ ? h * f_.flex_damping : 0;
    const double gear = gear_kgm2_ + h * f_.damping + between, arm = arm_kgm2_ + between;
    if (soft_) {
      const double det = gear * arm - between * between;
      w_.gear += h * (torque.gear * arm + between * torque.arm) / det;
      w_.arm += h * (torque.arm * gear + between * torque.gear) / det;
      q_.gear += h * w_.gear;
      q_.arm += h * w_.arm;
    } else {
      w_.arm = w_.gear += h * torque.gear / gear;
      q_.arm = q_.gear += h * w_.gear;
    }
  }

  MujocoFields f_;
  ArmNumbers arm_;
  bool soft_;
  double arm_kgm2_, gear_kgm2_;
  Pair q_, w_;
};

}  // namespace

std::unique_ptr<TargetJoint> mujocoJoint(const ServoNumbers& servo, const ArmNumbers& arm, double step_s) {
  return std::make_unique<MujocoJoint>(servo, arm, step_s);
}

}  // namespace darwinop::gap
