// Amplitudes of a stride, and foot poses over the gait period as sums of sinusoids.
#pragma once

#include "managers/gait/parameters.hpp"
#include "managers/gait/timing.hpp"

namespace darwinop::gait {

/// Step at an amplitude of 1: mm, mm, deg. Source: the upstream managers.
inline constexpr double kMaxX = 20, kMaxY = 40, kMaxA = 50;

/// Requested walk. `aim`: circles around a point in front, stepping to the other side.
struct WalkCommand {
  double x = 0, y = 0, a = 0;  // -1..1: forwards, left, counter-clockwise
  bool aim = false;

  [[nodiscard]] constexpr bool stands() const { return x == 0 && y == 0 && a == 0; }
};

/// Amplitudes of one command, constant from the middle of a swing to the next.
struct Stride {
  Stride(const WalkCommand& command, const Parameters& parameters);

  double x, body_x;
  double y, y_offset, body_y;
  double z, z_offset, body_z;
  double yaw, yaw_offset;  // rad
  bool stands;
};

/// Pose of a sole relative to that of the stretched leg: mm, x forwards, y left, z up; rad about the same axes.
struct Foot {
  double x, y, z, roll, pitch, yaw;
};

struct Feet {
  Foot right, left;
  double pelvis_right, pelvis_left;  // extra hip roll, deg
  double arm_right, arm_left;        // shoulder pitch from its rest position, deg
};

Feet feetAt(double time_ms, const Timing& timing, const Stride& stride, const Parameters& parameters);

}  // namespace darwinop::gait
