// Named initial poses of experiments.
#include "core/poses.hpp"

#include "core/conversions.hpp"
#include "experiments/format/experiment.hpp"

namespace darwinop::experiments {
namespace {

constexpr Pose fromTicks(const std::array<std::uint16_t, kJoints>& ticks) {
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
    {"start", "on its knees, stable without torque", fromTable(), false},
    {"standing", "on its feet with bent knees, ready to walk", fromTicks(kWalkReadyTicks), true},
}};

}  // namespace

const std::array<NamedPose, 2>& namedPoses() {
  return kPoses;
}

const Pose& startPose() {
  return kPoses[0].pose;
}

}  // namespace darwinop::experiments
