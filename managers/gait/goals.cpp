// Computes joint goals in servo ticks from feet, legs and arms.
#include "managers/gait/goals.hpp"

#include <algorithm>

namespace darwinop::gait {

namespace {

// Source: the ROBOTIS engine. Not 4096 / 360, so that goals are equal to it in every tick.
constexpr double kTicksPerDegree = 11.378;
constexpr double kDegreePerRad = 180 / kPi;
constexpr double kArmPGain = 8;

// Rest position of the arms, deg. Source: the ROBOTIS engine.
constexpr double kRestShoulderR = -48.345, kRestShoulderL = 41.313, kRestArmUpperR = -17.873, kRestArmUpperL = 17.580;
constexpr double kRestArmLowerR = 29.300, kRestArmLowerL = -29.593;

/// Both terms are truncated, as in the ROBOTIS engine.
int goalTick(double rest_deg, double from_rest_deg) {
  return kTickCentre + static_cast<int>(rest_deg * kTicksPerDegree) + static_cast<int>(from_rest_deg * kTicksPerDegree);
}

/// Sign of the servo angle for a positive leg angle.
struct Directions {
  int hip_yaw, hip_roll, hip_pitch, knee, ankle_pitch, ankle_roll;
};
constexpr Directions kRight{-1, -1, 1, 1, -1, 1}, kLeft{-1, -1, -1, -1, 1, 1};

struct LegJoints {
  Joint hip_yaw, hip_roll, hip_pitch, knee, ankle_pitch, ankle_roll;
};
constexpr LegJoints kRightLeg{Joint::kPelvYR,    Joint::kPelvR,  Joint::kLegUpperR,
                              Joint::kLegLowerR, Joint::kAnkleR, Joint::kFootR};
constexpr LegJoints kLeftLeg{Joint::kPelvYL,    Joint::kPelvL,  Joint::kLegUpperL,
                             Joint::kLegLowerL, Joint::kAnkleL, Joint::kFootL};

void addLeg(Goals& goals, const Leg& leg, const LegJoints& joint, const Directions& sign, double pelvis_deg,
            double hip_pitch_offset_deg) {
  goals[joint.hip_yaw] = goalTick(0, sign.hip_yaw * leg.hip_yaw * kDegreePerRad);
  goals[joint.hip_roll] = goalTick(0, sign.hip_roll * (leg.hip_roll * kDegreePerRad + pelvis_deg));
  goals[joint.hip_pitch] = goalTick(0, sign.hip_pitch * (leg.hip_pitch * kDegreePerRad - hip_pitch_offset_deg));
  goals[joint.knee] = goalTick(0, sign.knee * leg.knee * kDegreePerRad);
  goals[joint.ankle_pitch] = goalTick(0, sign.ankle_pitch * leg.ankle_pitch * kDegreePerRad);
  goals[joint.ankle_roll] = goalTick(0, sign.ankle_roll * leg.ankle_roll * kDegreePerRad);
}

}  // namespace

std::optional<Goals> goalsFor(const Feet& feet, const Parameters& p) {
  const std::optional<Leg> right = legFor(feet.right, p.ik), left = legFor(feet.left, p.ik);
  if (!right || !left) return std::nullopt;
  Goals goals;
  goals[Joint::kShoulderR] = goalTick(kRestShoulderR, feet.arm_right);
  goals[Joint::kShoulderL] = goalTick(kRestShoulderL, -feet.arm_left);
  goals[Joint::kArmUpperR] = goalTick(kRestArmUpperR, 0);
  goals[Joint::kArmUpperL] = goalTick(kRestArmUpperL, 0);
  goals[Joint::kArmLowerR] = goalTick(kRestArmLowerR, 0);
  goals[Joint::kArmLowerL] = goalTick(kRestArmLowerL, 0);
  addLeg(goals, *right, kRightLeg, kRight, feet.pelvis_right, p.hip_pitch_offset);
  addLeg(goals, *left, kLeftLeg, kLeft, feet.pelvis_left, p.hip_pitch_offset);
  return goals;
}

void clampToJoints(Goals& goals) {
  for (std::size_t i = 0; i < kWalkingJoints; ++i)
    goals.tick[i] = std::clamp<int>(goals.tick[i], kJointTable[i].low, kJointTable[i].high);
}

double pGain(Joint joint, const Parameters& p) {
  return isLeg(joint) ? p.p_gain : kArmPGain;
}

}  // namespace darwinop::gait
