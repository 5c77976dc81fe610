// Motor and joint equations of the plain body.
#include "hil-mocks/plain_body.hpp"

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"

namespace darwinop::hil {
namespace {

// MX-28 rotor inertia through the 193:1 gear (about 0.003 kg m2) plus a light limb.
constexpr double kInertia = 0.004;
// Damping of the shorted motor.
constexpr double kBackEmf = kMaxTorqueNm / kNoLoadSpeed;
// A limp joint decays with inertia / friction = 0.4 s.
constexpr double kFriction = 0.01;
constexpr double kLowest = -2048 * kRadPerTick, kHighest = 2047 * kRadPerTick;

constexpr double inertiaOf(std::size_t joint) {
  return kInertia * (1.0 + 0.02 * static_cast<double>(joint));
}

constexpr double settleErrorOf(std::size_t joint) {
  constexpr std::array<double, 3> kTicks{0, 1, -1};
  return kTicks[joint % 3] * kRadPerTick;
}

}  // namespace

PlainBody::PlainBody() {
  for (std::size_t i = 0; i < kJoints; ++i) place(static_cast<Joint>(i), radFromTicks(kJointTable[i].start).value);
}

void PlainBody::place(Joint joint, double position_rad) noexcept {
  state_.joint[index(joint)] = {position_rad, 0, 0};
  set_point_rad_[index(joint)] = position_rad;
}

void PlainBody::step(Nanos dt, const Drives& drives) noexcept {
  const double dt_s = std::chrono::duration<double>(dt).count();
  for (std::size_t i = 0; i < kJoints; ++i) {
    const ServoDrive& drive = drives[i];
    JointMotion& joint = state_.joint[i];
    double& set_point = set_point_rad_[i];

    double torque = 0, damping = kFriction;
    if (drive.torque_on) {
      const double way = drive.goal_rad + settleErrorOf(i) - set_point;
      const double reach = drive.speed_limit_rad_s * dt_s;
      set_point += std::clamp(way, -reach, reach);
      const double limit = std::clamp(drive.torque_limit, 0.0, 1.0);
      const double duty = std::clamp(drive.p_gain * (set_point - joint.position_rad) / kFullDriveError, -limit, limit);
      torque = duty * kMaxTorqueNm * drive.supply_v / kNominalSupply;
      damping += kBackEmf;
      joint.load = duty;
    } else {
      set_point = joint.position_rad;  // torque starts at the present position
      joint.load = 0;
    }

    // Implicit damping: stable for every step size.
    const double inertia = inertiaOf(i);
    joint.velocity_rad_s = (joint.velocity_rad_s + torque / inertia * dt_s) / (1.0 + damping / inertia * dt_s);
    joint.position_rad += joint.velocity_rad_s * dt_s;
    if (!drive.endless && (joint.position_rad < kLowest || joint.position_rad > kHighest)) {
      joint.position_rad = std::clamp(joint.position_rad, kLowest, kHighest);
      joint.velocity_rad_s = 0;
    }
  }
}

}  // namespace darwinop::hil
