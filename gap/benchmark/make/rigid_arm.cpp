#include "gap/benchmark/make/rigid_arm.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace darwinop::gap {
namespace {

constexpr double kStep = 1e-4;  // s

/// All torques but dry friction.
double freeTorque(const twin::Actuation& servo, double velocity, double outside) {
  return servo.torque_nm - servo.damping_nms_rad * velocity + outside;
}

}  // namespace

RigidArm::RigidArm(const twin::ServoParameters& parameters, std::vector<std::unique_ptr<twin::Effect>> effects,
                   const twin::Pendulum& pendulum)
    : servo_{parameters, std::move(effects)} {
  const twin::LoadChange& change = servo_.load();
  const double payload = pendulum.payload_kg * change.mass_scale, arm = pendulum.arm_mass_kg * change.mass_scale;
  const double out = pendulum.length_m + change.com_shift_m, middle = pendulum.length_m / 2 + change.com_shift_m;
  inertia_kgm2_ = payload * out * out + arm * (middle * middle + pendulum.length_m * pendulum.length_m / 12) +
                  parameters.armature_kgm2 + change.armature_kgm2;
  weight_nm_ = (payload * out + arm * middle) * pendulum.gravity_m_s2;
  hangs_at_rad_ = change.angle_offset_rad;
  if (!(inertia_kgm2_ > 0))
    throw std::runtime_error("hidden case: nothing on the servo has inertia; give it a payload");
}

void RigidArm::reset(const twin::BenchOptions& options) {
  servo_.reset(options.start_rad, options.session_time_s);
  position_ = options.start_rad;
  velocity_ = options.start_rad_s;
}

void RigidArm::step(const ServoDrive& drive) noexcept {
  servo_.firmware(drive, position_, velocity_);
  const double period_s = servo_.parameters().firmware_period_s;
  const int steps = std::max(1, static_cast<int>(std::lround(period_s / kStep)));
  for (int i = 0; i < steps; ++i) advance(period_s / steps);
}

void RigidArm::advance(double dt_s) noexcept {
  const double outside = gravityAt(position_);
  const twin::Actuation now = servo_.actuate(position_, velocity_, outside);
  if (now.follows_speed) return follow(now, outside, dt_s);
  const double push = freeTorque(now, velocity_, outside);
  const double stopping = -(push + inertia_kgm2_ * velocity_ / dt_s);
  const double friction = std::clamp(stopping, -now.friction_nm, now.friction_nm);
  const double middle = position_ + velocity_ * dt_s / 2;
  const double velocity = velocity_ + (push + friction) / inertia_kgm2_ * dt_s / 2;
  const double outside_middle = gravityAt(middle);
  const twin::Actuation then = servo_.actuate(middle, velocity, outside_middle);
  position_ += velocity * dt_s;
  velocity_ += (freeTorque(then, velocity, outside_middle) + friction) / inertia_kgm2_ * dt_s;
}

// Law speed_p: whatever torque reaches the speed within the step, as far as the motor has it.
void RigidArm::follow(const twin::Actuation& servo, double outside_nm, double dt_s) noexcept {
  const double push = freeTorque(servo, velocity_, outside_nm);
  double needed = inertia_kgm2_ * (servo.speed_rad_s - velocity_) / dt_s - push;
  if (servo.speed_rad_s != 0)
    needed += std::copysign(servo.friction_nm, servo.speed_rad_s);
  else  // friction helps to stop, and then holds
    needed = std::copysign(std::max(0.0, std::abs(needed) - servo.friction_nm), needed);
  const double torque = std::clamp(needed, -servo.speed_torque_nm, servo.speed_torque_nm);
  double after = servo.speed_rad_s;
  if (torque != needed) {
    const double stopping = -(push + torque + inertia_kgm2_ * velocity_ / dt_s);
    const double friction = std::clamp(stopping, -servo.friction_nm, servo.friction_nm);
    after = velocity_ + (push + torque + friction) / inertia_kgm2_ * dt_s;
  }
  servo_.noteMotorTorque(torque);
  position_ += (velocity_ + after) / 2 * dt_s;
  velocity_ = after;
}

double RigidArm::gravityAt(double position_rad) const noexcept {
  return -weight_nm_ * std::sin(position_rad - hangs_at_rad_);
}

}  // namespace darwinop::gap
