// Poses that experiments begin in.
#include "core/conversions.hpp"
#include "experiments/format/experiment.hpp"

namespace darwinop::experiments {
namespace {

using Ticks = std::array<std::uint16_t, kJoints>;

// Source: page 9 "walkready" of the motion file that is delivered with the robot: knees bent, soles flat, arms as in
// the start pose.
constexpr Ticks kWalkReady{1498, 2518, 1845, 2248, 2381, 1712, 2048, 2048, 2052, 2044,
                           1637, 2459, 2653, 1443, 2389, 1707, 2057, 2039, 2048, 2161};

constexpr Pose fromTicks(const Ticks& ticks) {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = radFromTicks(ticks[i]).value;
  return pose;
}

constexpr Pose fromTable() {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = radFromTicks(kJointTable[i].start).value;
  return pose;
}

constexpr std::array<NamedPose, 2> kPoses{{
    {"start", "on its knees, as the robot rests", fromTable(), false},
    {"standing", "on its feet with bent knees, ready to walk", fromTicks(kWalkReady), true},
}};

}  // namespace

const std::array<NamedPose, 2>& namedPoses() {
  return kPoses;
}

const Pose& startPose() {
  return kPoses[0].pose;
}

}  // namespace darwinop::experiments
