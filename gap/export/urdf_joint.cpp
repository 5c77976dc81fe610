// URDF describes a joint without its controller. Assumed here is the best possible controller: at the goal in the next
// step, as far as effort and velocity allow.
#include <algorithm>

#include "gap/export/fields.hpp"
#include "gap/export/joints.hpp"
#include "twin/servo/shaft.hpp"

namespace darwinop::gap {
namespace {

class UrdfJoint final : public TargetJoint {
 public:
  UrdfJoint(const ServoNumbers& servo, const ArmNumbers& arm, double step_s)
      : f_{urdfFields(servo)},
        arm_{arm},
        h_{step_s},
        link_kgm2_{std::max(arm.inertia_kgm2 + servo.armature_kgm2, kLightestLink)} {}

  void reset(double position_rad) override {
    q_ = position_rad;
    w_ = 0;
  }

  void step(bool torque_on, double goal_rad) override {
    const twin::Actuation servo{.torque_nm = 0,
                                .damping_nms_rad = f_.damping,
                                .friction_nm = f_.friction,
                                .follows_speed = torque_on,
                                .speed_rad_s = std::clamp((goal_rad - q_) / h_, -f_.velocity, f_.velocity),
                                .speed_torque_nm = f_.effort};
    w_ = shaft_.kick(w_, servo, arm_.gravityAt(q_), link_kgm2_, h_);
    q_ += h_ * w_;
  }

  [[nodiscard]] double position_rad() const override { return q_; }
  [[nodiscard]] double velocity_rad_s() const override { return w_; }

 private:
  UrdfFields f_;
  ArmNumbers arm_;
  double h_, link_kgm2_;
  twin::Shaft shaft_;
  double q_ = 0, w_ = 0;
};

}  // namespace

std::unique_ptr<TargetJoint> urdfJoint(const ServoNumbers& servo, const ArmNumbers& arm, double step_s) {
  return std::make_unique<UrdfJoint>(servo, arm, step_s);
}

}  // namespace darwinop::gap
