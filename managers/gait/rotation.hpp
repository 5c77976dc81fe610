// Rotation matrices for the leg kinematics: rad about x forwards, y left, z up.
#pragma once

#include <cmath>

namespace darwinop::gait {

struct Vector {
  double x, y, z;
};

struct Rotation {
  double m[3][3];
};

inline Rotation aboutX(double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  return {{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
}

inline Rotation aboutY(double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  return {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
}

inline Rotation aboutZ(double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
}

constexpr Rotation operator*(const Rotation& a, const Rotation& b) {
  Rotation out{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.m[i][j] = a.m[i][0] * b.m[0][j] + a.m[i][1] * b.m[1][j] + a.m[i][2] * b.m[2][j];
  return out;
}

constexpr Vector operator*(const Rotation& a, const Vector& v) {
  return {a.m[0][0] * v.x + a.m[0][1] * v.y + a.m[0][2] * v.z, a.m[1][0] * v.x + a.m[1][1] * v.y + a.m[1][2] * v.z,
          a.m[2][0] * v.x + a.m[2][1] * v.y + a.m[2][2] * v.z};
}

/// Inverse of a rotation: its transpose.
constexpr Rotation inverse(const Rotation& a) {
  return {{{a.m[0][0], a.m[1][0], a.m[2][0]}, {a.m[0][1], a.m[1][1], a.m[2][1]}, {a.m[0][2], a.m[1][2], a.m[2][2]}}};
}

}  // namespace darwinop::gait
