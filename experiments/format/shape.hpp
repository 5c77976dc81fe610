// Goal trajectories.
#pragma once

#include "experiments/format/experiment.hpp"

namespace darwinop::experiments {

/// Goal in rad, `t` seconds after the start of the phase, at which the goal was `begin`. `sign` -1 mirrors it.
double goalAt(const Goal& goal, double duration_s, double sign, double begin, double t);

/// True if the goal is discontinuous: the speed limit determines the joint's speed.
constexpr bool jumps(Shape shape) {
  return shape == Shape::kStep || shape == Shape::kSteps;
}

/// True if the goal oscillates around its value at the start of the phase, which must be known.
constexpr bool swings(Shape shape) {
  return shape == Shape::kTriangle || shape == Shape::kSine || shape == Shape::kChirp || shape == Shape::kMultisine;
}

/// Quintic from 0 to 1 with zero velocity and acceleration at both ends; maximum slope kSteepest.
double smooth(double share);
inline constexpr double kSteepest = 1.875;

}  // namespace darwinop::experiments
