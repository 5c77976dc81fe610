// Leg inverse kinematics: joint angles from the pose of the sole, exact or with the defect of the published engine.
#include "managers/gait/leg.hpp"

#include <cmath>

#include "managers/gait/rotation.hpp"

namespace darwinop::gait {

namespace {

// mm. Source: drawings of the DARwIn-OP.
constexpr double kThigh = 93, kCalf = 93, kAnkle = 33.5, kLegLength = kThigh + kCalf + kAnkle;

}  // namespace

std::optional<Leg> legFor(const Foot& foot, Ik ik) {
  const Rotation sole = aboutZ(foot.yaw) * aboutY(foot.pitch) * aboutX(foot.roll);
  const Vector from_hip{foot.x, foot.y, foot.z - kLegLength};  // hip to sole
  const Vector ankle{from_hip.x + kAnkle * sole.m[0][2], from_hip.y + kAnkle * sole.m[1][2],
                     from_hip.z + kAnkle * sole.m[2][2]};
  Leg leg{};

  // Law of cosines; NaN if out of reach, which propagates to all angles below.
  const double reach2 = ankle.x * ankle.x + ankle.y * ankle.y + ankle.z * ankle.z;
  const double bend = (reach2 - kThigh * kThigh - kCalf * kCalf) / (2 * kThigh * kCalf);
  leg.knee = std::acos(bend);

  // Hip in the sole frame: the ankle roll axis must point at it.
  const Vector hip = inverse(sole) * Vector{-from_hip.x, -from_hip.y, -from_hip.z};
  leg.ankle_roll = std::atan2(hip.y, hip.z - kAnkle);

  Rotation thigh = sole * aboutX(-leg.ankle_roll);
  if (ik == Ik::kFlawed)
    for (int i = 0; i < 3; ++i) thigh.m[i][i] += 1;
  const auto& m = thigh.m;
  leg.hip_yaw = std::atan2(-m[0][1], m[1][1]);
  const double sin_yaw = std::sin(leg.hip_yaw), cos_yaw = std::cos(leg.hip_yaw);
  leg.hip_roll = std::atan2(m[2][1], -m[0][1] * sin_yaw + m[1][1] * cos_yaw);
  const double sin_roll = std::sin(leg.hip_roll), cos_roll = std::cos(leg.hip_roll);
  // Sum of hip, knee and ankle pitch.
  const double pitch = std::atan2(m[0][2] * cos_yaw + m[1][2] * sin_yaw, m[0][0] * cos_yaw + m[1][0] * sin_yaw);

  // In the plane of the leg.
  const double k = kCalf * std::sin(leg.knee), l = -kThigh - kCalf * std::cos(leg.knee);
  const double forward = cos_yaw * ankle.x + sin_yaw * ankle.y;
  const double up = cos_roll * ankle.z + sin_yaw * sin_roll * ankle.x - cos_yaw * sin_roll * ankle.y;
  const double s = (k * up + l * forward) / (k * k + l * l);
  leg.hip_pitch = std::atan2(s, (up - k * s) / l);
  leg.ankle_pitch = pitch - leg.knee - leg.hip_pitch;
  if (!std::isfinite(leg.ankle_pitch)) return std::nullopt;  // out of reach, or singular
  return leg;
}

}  // namespace darwinop::gait
