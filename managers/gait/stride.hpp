// The amplitudes of one step, and where the feet are at a time of the period: sums of sinusoids.
#pragma once

#include "managers/gait/parameters.hpp"
#include "managers/gait/timing.hpp"

namespace darwinop::gait {

/// Greatest step at an amplitude of 1: mm, mm, deg. Source: the upstream managers.
inline constexpr double kGreatestX = 20, kGreatestY = 40, kGreatestA = 50;

/// What the user asks for. `aim`: turns around what is in front, stepping to the other side.
struct Wish {
  double x = 0, y = 0, a = 0;  // -1..1: forwards, left, counter-clockwise
  bool aim = false;

  [[nodiscard]] constexpr bool stands() const { return x == 0 && y == 0 && a == 0; }
};

/// Amplitudes that one wish gives; in force from the middle of a swing to the next.
struct Stride {
  Stride(const Wish& wish, const Parameters& parameters);

  double x, body_x;
  double y, y_offset, body_y;
  double z, z_offset, body_z;
  double yaw, yaw_offset;  // rad
  bool stands;
};

/// Place of a sole: mm from where it is under the stretched leg, x forwards, y left, z up; rad about the same axes.
struct Foot {
  double x, y, z, roll, pitch, yaw;
};

struct Feet {
  Foot right, left;
  double pelvis_right, pelvis_left;  // extra hip roll, deg
  double arm_right, arm_left;        // shoulder pitch from its rest, deg
};

Feet feetAt(double time_ms, const Timing& timing, const Stride& stride, const Parameters& parameters);

}  // namespace darwinop::gait
