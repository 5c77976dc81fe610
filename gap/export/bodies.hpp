// Gear side and arm under constraints, for simulators that solve for constraint forces.
#pragma once

#include <array>
#include <span>

namespace darwinop::gap {

/// Angles and speeds of the gear side and of the arm; a rigid joint moves them together.
struct Pair {
  double gear = 0, arm = 0;
};

/// A force that changes a velocity (or acceleration) along `direction` until it is `wanted`, as far as its bounds let
/// it. `softness`: how far it gives way per force.
struct Constraint {
  Pair direction;
  double wanted = 0;
  double low = 0, high = 0;
  double softness = 0;
};

/// Forces of at most two constraints. `free`: the motion without them; `mobility`: change of it per force.
std::array<double, 2> solveConstraints(std::span<const Constraint> constraints, const Pair& mobility, const Pair& free);

}  // namespace darwinop::gap
