// The goal of a joint at any time of a phase.
#pragma once

#include "experiments/format/experiment.hpp"

namespace darwinop::experiments {

/// rad, `t` seconds after the phase began, when the joint's goal was `begin`. `sign` -1 mirrors it.
double goalAt(const Goal& goal, double duration_s, double sign, double begin, double t);

/// The goal jumps: how fast the joint follows is the speed limit's business.
constexpr bool jumps(Shape shape) {
  return shape == Shape::kStep || shape == Shape::kSteps;
}

/// The goal swings around where the phase begins, which must be known then.
constexpr bool swings(Shape shape) {
  return shape == Shape::kTriangle || shape == Shape::kSine || shape == Shape::kChirp || shape == Shape::kMultisine;
}

/// 0 to 1 for 0 to 1, at rest at both ends; 1.875 at its steepest.
double smooth(double share);
inline constexpr double kSteepest = 1.875;

}  // namespace darwinop::experiments
