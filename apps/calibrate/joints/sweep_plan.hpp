// Where and how each joint is swept on a robot with a clamped trunk, so that gravity shows its zero.
#pragma once

#include <array>
#include <bitset>
#include <numbers>
#include <span>
#include <vector>

#include "apps/calibrate/joints/gravity_model.hpp"
#include "apps/calibrate/posture.hpp"
#include "core/conversions.hpp"

namespace darwinop::calibrate {

/// Joints of one chain, from the trunk outwards. With a clamped trunk chains do not act on each other.
using Limb = std::vector<Joint>;
std::span<const Limb> limbs();

/// Without limbs that lack a joint: nothing shows where the rest of them is.
std::bitset<kJoints> sweptJoints(const std::bitset<kJoints>& absent);

struct SweepOfJoint {
  double base_rad, amplitude_rad;
  double p_gain;  // low where gravity is weak: an encoder tick then changes the load by less
  int repeats;    // in each posture
};
/// Within the joint's limits; legs apart, so that they do not touch.
SweepOfJoint sweepOf(Joint joint);

/// Pose in which the other joints wait.
JointValues basePose();

/// Joints that are swept at the same time: at most one of each limb.
std::vector<std::bitset<kJoints>> rounds(const std::bitset<kJoints>& wanted);

/// To each side of the base pose, of the joint that swings farthest; rounded up.
double greatestSweepDeg();

/// In each posture.
double sweepMinutes();

/// Postures of the trunk: each axis is across gravity in two of them.
std::span<const TrunkPosture* const> sweepPostures();

/// rad/s. In a cycle of 16 ms a joint then advances by 2.618 encoder ticks: no other fraction than the golden ratio's
/// spreads the rounding of successive readings more evenly over a tick.
inline constexpr double kSweepSpeed = (1 + std::numbers::phi) * kRadPerTick / 0.016;

}  // namespace darwinop::calibrate
