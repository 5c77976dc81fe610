#include "gap/plan/arm_setup.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/format/plan.hpp"
#include "experiments/format/shape.hpp"
#include "gap/plan/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr double kSettle = 1;  // s

struct ArmRow {
  Joint joint;
  double hangs_at_rad;  // docs/experiments.md, delivered experiments
};
constexpr std::array<ArmRow, 4> kArms{
    {{Joint::kShoulderR, 0}, {Joint::kShoulderL, 0}, {Joint::kArmUpperR, -0.8}, {Joint::kArmUpperL, 0.8}}};

/// The elbow straight, the upper arm beside the trunk: the shoulder swings all of the arm.
void stretchArm(Joint joint, experiments::Pose& pose) {
  const bool right = joint == Joint::kShoulderR || joint == Joint::kArmUpperR;
  if (!right && joint != Joint::kShoulderL && joint != Joint::kArmUpperL) return;
  pose[index(right ? Joint::kShoulderR : Joint::kShoulderL)] = 0;
  pose[index(right ? Joint::kArmUpperR : Joint::kArmUpperL)] = right ? -0.65 : 0.65;
  pose[index(right ? Joint::kArmLowerR : Joint::kArmLowerL)] = right ? -1.55 : 1.55;
}

}  // namespace

ArmSetup armSetupFor(Joint joint, std::optional<double> hangs_at_rad) {
  ArmSetup stand;
  stand.joint = joint;
  for (const ArmRow& arm : kArms)
    if (arm.joint == joint) stand.hangs_at_rad = arm.hangs_at_rad;
  if (hangs_at_rad) stand.hangs_at_rad = *hangs_at_rad;

  experiments::ExperimentSetup& setup = stand.setup;
  setup.named = experiments::namedPoses().data();
  setup.pose = experiments::startPose();
  stretchArm(joint, setup.pose);
  const safety::JointRange range = safety::hardRange(joint);
  setup.pose[index(joint)] = std::clamp(stand.hangs_at_rad, range.low.value + thresholds::kStartMargin,
                                        range.high.value - thresholds::kStartMargin);
  setup.settle_s = kSettle;
  takeTimeFor(setup);
  return stand;
}

void takeTimeFor(experiments::ExperimentSetup& setup) {
  double way = 0;
  for (std::size_t i = 0; i < kJoints; ++i) way = std::max(way, std::abs(setup.pose[i] - experiments::startPose()[i]));
  setup.duration_s = std::max(2.0, std::ceil(experiments::kSteepest * way / experiments::kSetupMost));
}

}  // namespace darwinop::gap
