// Amplitudes of a stride, and foot poses over the gait period as sums of sinusoids.
#include "managers/gait/stride.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace darwinop::gait {

namespace {

// Source of both: the ROBOTIS engine. Additional lateral swing of the body per foot distance; hip roll of the stance
// leg as a fraction of that of the swing leg.
constexpr double kSwingPerSpread = 0.04;
constexpr double kStandingHipShare = 0.35;

constexpr double kTurn = 2 * kPi;

/// Progress of the swing: -1 left foot behind, +1 left foot in front; constant while both feet are down.
double progress(double t, const Timing& timing) {
  if (t <= timing.right_up)
    return -std::cos(kTurn * (std::clamp(t, timing.left_up, timing.left_down) - timing.left_up) / timing.move());
  return std::cos(kTurn * (std::min(t, timing.right_down) - timing.right_up) / timing.move());
}

/// 1 on the ground, -1 at the highest point, for a foot in the air from `up` to `down`.
double ground(double t, double up, double down, const Timing& timing) {
  return std::cos(kTurn * (std::clamp(t, up, down) - up) / timing.lift());
}

void addPelvis(Feet& feet, double t, const Timing& timing, double pelvis_deg) {
  const double swinging = pelvis_deg / 2, standing = kStandingHipShare * pelvis_deg / 2;
  if (t > timing.left_up && t <= timing.left_down) {
    const double lifted = 1 - ground(t, timing.left_up, timing.left_down, timing);
    feet.pelvis_left = standing * lifted;
    feet.pelvis_right = -swinging * lifted;
  } else if (t > timing.right_up && t <= timing.right_down) {
    const double lifted = 1 - ground(t, timing.right_up, timing.right_down, timing);
    feet.pelvis_left = swinging * lifted;
    feet.pelvis_right = -standing * lifted;
  }
}

}  // namespace

Stride::Stride(const WalkCommand& command, const Parameters& p)
    : x{kMaxX * command.x},
      body_x{x * p.step_forward_back_ratio},
      y{kMaxY * command.y / 2},
      y_offset{std::abs(y)},
      body_y{p.swing_right_left + y_offset * kSwingPerSpread},
      z{p.foot_height / 2},
      z_offset{z / 2},
      body_z{p.swing_top_down},
      yaw{kMaxA * command.a * kRadPerDegree / 2},
      yaw_offset{std::abs(yaw)},
      stands{command.stands()} {
  if (command.aim) {
    yaw = -yaw;
    yaw_offset = -yaw_offset;
  }
}

Feet feetAt(double t, const Timing& timing, const Stride& stride, const Parameters& p) {
  const double once = kTurn * t / timing.period;
  const double body_x = -stride.body_x * std::sin(2 * once);
  const double body_y = stride.body_y * std::sin(once);
  const double body_z = stride.body_z * (1 + std::cos(2 * once));
  const double q = progress(t, timing);
  const double z_left = stride.z_offset - stride.z * ground(t, timing.left_up, timing.left_down, timing);
  const double z_right = stride.z_offset - stride.z * ground(t, timing.right_up, timing.right_down, timing);
  const double roll = p.roll_offset / 2 * kRadPerDegree;
  const double pitch = p.pitch_offset * kRadPerDegree;
  const double yaw = p.yaw_offset / 2 * kRadPerDegree;
  const double arm = stride.x * p.arm_swing_gain * std::cos(once);

  Feet feet{};
  feet.right = {body_x - stride.x * q + p.x_offset,
                body_y - stride.y * q - stride.y_offset - p.y_offset / 2,
                body_z + z_right + p.z_offset,
                -roll,
                pitch,
                -stride.yaw * q - stride.yaw_offset - yaw};
  feet.left = {body_x + stride.x * q + p.x_offset,
               body_y + stride.y * q + stride.y_offset + p.y_offset / 2,
               body_z + z_left + p.z_offset,
               roll,
               pitch,
               stride.yaw * q + stride.yaw_offset + yaw};
  feet.arm_right = -arm;
  feet.arm_left = arm;
  addPelvis(feet, t, timing, p.pelvis_offset);
  return feet;
}

}  // namespace darwinop::gait
