// What makes a walk in the twin harder: a push, a slope.
#pragma once

#include <mujoco/mujoco.h>

#include <chrono>
#include <cmath>

#include "twin_walk_rig.hpp"

namespace managers {

enum class Ground { kLevel, kPush, kSlope };

inline constexpr double kFallen = 0.7;  // cosine of the tilt: 45 degrees

/// Downhill is forwards.
inline void tilt(darwinop::twin::RobotBody& body, double rad) {
  mjModel& model = *const_cast<mjModel*>(static_cast<const mjModel*>(body.mujocoModel()));
  const double g = std::hypot(model.opt.gravity[0], model.opt.gravity[2]);
  model.opt.gravity[0] = g * std::sin(rad);
  model.opt.gravity[2] = -g * std::cos(rad);
}

/// Walks forwards until `moment_s` after the start of a gait period; pushed from behind then, or on a slope for 1.2 s.
inline void walkOn(TwinWalk& walk, Ground ground, double moment_s) {
  constexpr double kSlopeRad = 3 * darwinop::kRadPerDegree;
  walk.start(1);
  walk.loop(TwinWalk::kStance + 1.2);
  if (ground == Ground::kSlope) tilt(walk.body(), kSlopeRad);
  walk.loop(1.2 + moment_s);
  if (ground == Ground::kPush) walk.body().push({5, 0, 0}, std::chrono::milliseconds{100});
}

/// Until the robot is released.
inline void runToRest(TwinWalk& walk, int cycles) {
  for (int i = 0; i < cycles && walk.state() != darwinop::State::kLimp; ++i) walk.runLoop(1);
}

}  // namespace managers
