// Leg inverse kinematics against forward kinematics written down by themselves, with and without the flaw.
#include "managers/gait/leg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "managers/gait/rotation.hpp"

namespace darwinop::gait {
namespace {

constexpr double kThigh = 93, kCalf = 93, kAnkle = 33.5, kStretched = 219.5;

struct Sole {
  Vector place;
  Rotation turned;
};

/// From the hip down: what the joints do when they have these angles.
Sole soleOf(const Leg& leg) {
  const Rotation hip = aboutZ(leg.hip_yaw) * aboutX(leg.hip_roll) * aboutY(leg.hip_pitch);
  const Rotation knee = hip * aboutY(leg.knee);
  const Rotation sole = knee * aboutY(leg.ankle_pitch) * aboutX(leg.ankle_roll);
  const Vector thigh = hip * Vector{0, 0, -kThigh}, calf = knee * Vector{0, 0, -kCalf},
               foot = sole * Vector{0, 0, -kAnkle};
  return {{thigh.x + calf.x + foot.x, thigh.y + calf.y + foot.y, thigh.z + calf.z + foot.z + kStretched}, sole};
}

double apartMm(const Foot& wanted, const Sole& got) {
  return std::hypot(wanted.x - got.place.x, wanted.y - got.place.y, wanted.z - got.place.z);
}

/// Angle between where the sole points and where it should, deg.
double turnedDeg(const Foot& wanted, const Sole& got) {
  const Rotation error = inverse(aboutZ(wanted.yaw) * aboutY(wanted.pitch) * aboutX(wanted.roll)) * got.turned;
  const double trace = error.m[0][0] + error.m[1][1] + error.m[2][2];
  return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) / kRadPerDegree;
}

TEST(Leg, ExactPutsTheSoleWhereItWasAsked) {
  int reached = 0;
  for (double x : {-40.0, 0.0, 30.0})
    for (double y : {-40.0, -3.0, 0.0, 25.0})
      for (double z : {12.0, 30.0, 60.0})
        for (double yaw : {-0.6, 0.0, 0.3})
          for (double pitch : {-0.2, 0.0, 0.15})
            for (double roll : {-0.1, 0.0, 0.2}) {
              const Foot foot{x, y, z, roll, pitch, yaw};
              const auto leg = legFor(foot, Ik::kExact);
              if (!leg) continue;
              ++reached;
              EXPECT_LT(apartMm(foot, soleOf(*leg)), 1e-9);
              EXPECT_LT(turnedDeg(foot, soleOf(*leg)), 1e-5);
            }
  EXPECT_GT(reached, 800);
}

TEST(Leg, TheFlawHalvesRollAndYawOfTheHip) {
  const Foot sideways{0, 20, 20, 0, 0, 0};
  const Leg flawed = *legFor(sideways, Ik::kFlawed), exact = *legFor(sideways, Ik::kExact);
  EXPECT_NEAR(flawed.ankle_roll, exact.ankle_roll, 1e-12);
  EXPECT_NEAR(exact.hip_roll, -exact.ankle_roll, 1e-12);
  EXPECT_NEAR(flawed.hip_roll, -exact.ankle_roll / 2, 1e-12);

  const Foot turned{0, 0, 20, 0, 0, 0.4};
  EXPECT_NEAR(legFor(turned, Ik::kExact)->hip_yaw, 0.4, 1e-12);
  EXPECT_NEAR(legFor(turned, Ik::kFlawed)->hip_yaw, 0.2, 1e-12);
}

TEST(Leg, TheFlawIsThisLargeAtTheSole) {
  // The numbers of docs/gait.md: where the sole goes that was asked to go 20 mm aside, and one turned by 25 degrees.
  const Foot sideways{0, 20, 20, 0, 0, 0}, turned{0, 0, 20, 0, 0, 25 * kRadPerDegree};
  const Sole aside = soleOf(*legFor(sideways, Ik::kFlawed)), around = soleOf(*legFor(turned, Ik::kFlawed));
  EXPECT_NEAR(aside.place.y, 8.0, 0.05);
  EXPECT_NEAR(turnedDeg(sideways, aside), 3.43, 0.05);
  EXPECT_NEAR(turnedDeg(turned, around), 12.5, 0.01);
}

TEST(Leg, SaysWhatItCannotReach) {
  EXPECT_FALSE(legFor({0, 0, -1, 0, 0, 0}, Ik::kFlawed));   // longer than it is
  EXPECT_FALSE(legFor({150, 0, 10, 0, 0, 0}, Ik::kExact));  // the same, aside
  EXPECT_FALSE(legFor({0, 0, 186, 0, 0, 0}, Ik::kFlawed));  // folded into a point
  EXPECT_FALSE(legFor({std::nan(""), 0, 20, 0, 0, 0}, Ik::kFlawed));
  EXPECT_TRUE(legFor({0, 0, 1, 0, 0, 0}, Ik::kFlawed));
}

}  // namespace
}  // namespace darwinop::gait
