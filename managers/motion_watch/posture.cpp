// Posture from accelerometer and knee angles.
#include "managers/motion_watch/posture.hpp"

#include <array>
#include <cmath>

#include "core/units.hpp"

namespace darwinop::motion {

namespace {

constexpr double kTilted = 0.70710678;        // cos 45 degrees
constexpr double kBent = 90 * kRadPerDegree;  // rad; 53 degrees ready to walk, 129 on its knees

/// Smaller of both knee bends, rad; NaN if both are unknown. The left knee bends to negative angles.
double kneeBend(const Sensors& sensors) {
  const double right = sensors.joint[index(Joint::kLegLowerR)].position.value;
  const double left = -sensors.joint[index(Joint::kLegLowerL)].position.value;
  return std::fmin(right, left);  // ignores a single NaN
}

}  // namespace

Posture postureOf(const Sensors& sensors) {
  const auto& up = sensors.board.accelerometer;  // points upwards at rest; x right, y forwards
  const double x = up[0].value, y = up[1].value, z = up[2].value, g = std::hypot(x, y, z);
  if (!(g > 0.5 * kGravity && g < 1.5 * kGravity)) return Posture::kUnknown;
  if (z / g >= kTilted) return kneeBend(sensors) >= kBent ? Posture::kSits : Posture::kStands;
  if (-z / g >= kTilted) return Posture::kUpsideDown;
  if (std::abs(y) >= std::abs(x)) return y < 0 ? Posture::kOnFace : Posture::kOnBack;
  return x < 0 ? Posture::kOnRight : Posture::kOnLeft;
}

std::string_view textOf(Posture posture) {
  constexpr std::array<std::string_view, 8> kTexts{"has an unknown posture: no accelerometer, or it is still moving",
                                                   "stands",
                                                   "sits or kneels",
                                                   "lies on its face",
                                                   "lies on its back",
                                                   "lies on its right side",
                                                   "lies on its left side",
                                                   "is upside down"};
  return kTexts[static_cast<std::size_t>(posture)];
}

}  // namespace darwinop::motion
