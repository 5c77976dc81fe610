#include "apps/calibrate/joints/sweep_plan.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::calibrate {
namespace {

using enum Joint;

struct Row {
  Joint right;
  SweepOfJoint sweep;  // of the right one; the left one is mirrored
};

// Amplitudes: limits of the joint table allow them everywhere, with an offset of 0.06 rad.
// Gains: the heaviest joint (hip, 1 N m) then trails by less than 0.15 rad.
// Repeats: as many as the weakest joints need. A foot turns 0.02 N m, and a tick at P gain 1 is 0.005 N m.
constexpr std::array kPairs{
    Row{kShoulderR, {0.2, 0.6, 2, 4}}, Row{kArmUpperR, {0.5, 0.6, 2, 5}}, Row{kArmLowerR, {-0.25, 0.8, 1, 9}},
    Row{kPelvYR, {-0.2, 0.5, 2, 1}},   Row{kPelvR, {0.4, 0.35, 4, 1}},    Row{kLegUpperR, {-0.7, 0.4, 4, 1}},
    Row{kLegLowerR, {0.9, 0.7, 1, 3}}, Row{kAnkleR, {0.1, 0.9, 1, 6}},    Row{kFootR, {0.2, 0.7, 1, 6}},
};
constexpr SweepOfJoint kNeckSweep{0, 0.8, 1, 8}, kHeadSweep{0.29, 0.55, 1, 10};

}  // namespace

std::span<const Limb> limbs() {
  static const std::array<Limb, 5> kLimbs{{{kShoulderR, kArmUpperR, kArmLowerR},
                                           {kShoulderL, kArmUpperL, kArmLowerL},
                                           {kPelvYR, kPelvR, kLegUpperR, kLegLowerR, kAnkleR, kFootR},
                                           {kPelvYL, kPelvL, kLegUpperL, kLegLowerL, kAnkleL, kFootL},
                                           {kNeck, kHead}}};
  return kLimbs;
}

std::bitset<kJoints> sweptJoints(const std::bitset<kJoints>& absent) {
  std::bitset<kJoints> out;
  for (const Limb& limb : limbs())
    if (std::ranges::none_of(limb, [&](Joint joint) { return absent[index(joint)]; }))
      for (const Joint joint : limb) out.set(index(joint));
  return out;
}

SweepOfJoint sweepOf(Joint joint) {
  if (joint == kNeck) return kNeckSweep;
  if (joint == kHead) return kHeadSweep;
  // Odd ids are the right side, and the left partner has the next one.
  const auto right = static_cast<Joint>(index(joint) / 2 * 2);
  SweepOfJoint sweep = std::ranges::find(kPairs, right, &Row::right)->sweep;
  if (right != joint) sweep.base_rad = -sweep.base_rad;
  return sweep;
}

JointValues basePose() {
  JointValues pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = sweepOf(static_cast<Joint>(i)).base_rad;
  return pose;
}

std::vector<std::bitset<kJoints>> rounds(const std::bitset<kJoints>& wanted) {
  std::vector<std::bitset<kJoints>> out;
  for (const Limb& limb : limbs()) {
    std::size_t round = 0;
    for (const Joint joint : limb)
      for (int repeat = 0; wanted[index(joint)] && repeat < sweepOf(joint).repeats; ++repeat) {
        if (round == out.size()) out.emplace_back();
        out[round++].set(index(joint));
      }
  }
  return out;
}

double greatestSweepDeg() {
  double greatest = 0;
  for (std::size_t i = 0; i < kJoints; ++i) greatest = std::max(greatest, sweepOf(static_cast<Joint>(i)).amplitude_rad);
  return std::ceil(greatest / kRadPerDegree);
}

double sweepMinutes() {
  double seconds = 0;
  for (const std::bitset<kJoints>& round : rounds(sweptJoints({}))) {
    double longest = 0;
    forEachJoint(round,
                 [&](std::size_t i) { longest = std::max(longest, sweepOf(static_cast<Joint>(i)).amplitude_rad); });
    constexpr double kMovesS = 3;  // there and back
    seconds += 4 * longest / kSweepSpeed + kMovesS;
  }
  return std::ceil(seconds / 60);
}

std::span<const TrunkPosture* const> sweepPostures() {
  static constexpr std::array kUsed{&kPostures[0], &kPostures[1], &kPostures[3]};  // upright, back, right side
  return kUsed;
}

}  // namespace darwinop::calibrate
