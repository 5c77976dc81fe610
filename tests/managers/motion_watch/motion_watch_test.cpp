// Statistics of a motion: peak errors and loads per joint, faults; posture afterwards.
#include "managers/motion_watch/motion_watch.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/conversions.hpp"
#include "managers/motion_watch/posture.hpp"

namespace darwinop::motion {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kG = 9.80665;

Sensors resting(double x, double y, double z, double knee_degrees) {
  Sensors sensors;
  sensors.board.accelerometer = {MeterPerSec2{x}, MeterPerSec2{y}, MeterPerSec2{z}};
  sensors.joint[index(Joint::kLegLowerR)].position = Rad{knee_degrees * kRadPerDegree};
  sensors.joint[index(Joint::kLegLowerL)].position = Rad{-knee_degrees * kRadPerDegree};
  return sensors;
}

TEST(Posture, KneesDistinguishSittingFromStanding) {
  EXPECT_EQ(postureOf(resting(0, 0, kG, 53)), Posture::kStands);
  EXPECT_EQ(postureOf(resting(0, 0, kG, 129)), Posture::kSits);
  Sensors one_knee = resting(0, 0, kG, 129);
  one_knee.joint[index(Joint::kLegLowerL)].position = Rad{};
  EXPECT_EQ(postureOf(one_knee), Posture::kSits);
  EXPECT_EQ(postureOf(resting(0, 0, kG, kUnknown)), Posture::kStands);
}

TEST(Posture, LyingHasASide) {
  EXPECT_EQ(postureOf(resting(0, -kG, 0, 53)), Posture::kOnFace);
  EXPECT_EQ(postureOf(resting(0, kG, 1, 53)), Posture::kOnBack);
  EXPECT_EQ(postureOf(resting(-kG, 1, 0, 53)), Posture::kOnRight);
  EXPECT_EQ(postureOf(resting(kG, 1, 0, 53)), Posture::kOnLeft);
  EXPECT_EQ(postureOf(resting(0, 0, -kG, 53)), Posture::kUpsideDown);
}

TEST(Posture, IsUnknownWithoutAMeasurementOrInFreeFall) {
  EXPECT_EQ(postureOf(Sensors{}), Posture::kUnknown);
  EXPECT_EQ(postureOf(resting(0, 0, 1, 53)), Posture::kUnknown);
}

/// All joints at their goals.
Sensors following() {
  Sensors sensors;
  for (JointSensors& joint : sensors.joint) {
    joint.motion.received();
    joint.commanded = joint.position = Rad{0};
    joint.load = 0;
  }
  return sensors;
}

TEST(MotionWatch, StoresThePeakOfEachJointWithItsTime) {
  MotionWatch watch;
  Sensors seen = following();
  auto& neck = seen.joint[index(Joint::kNeck)];
  neck.position = Rad{-0.2};
  neck.load = -0.5;
  watch.update(seen, 1);
  neck.position = Rad{0.1};
  neck.load = 0.25;
  watch.update(seen, 2);
  EXPECT_DOUBLE_EQ(watch.error(Joint::kNeck).value, 0.2);
  EXPECT_DOUBLE_EQ(watch.error(Joint::kNeck).seconds, 1);
  EXPECT_DOUBLE_EQ(watch.load(Joint::kNeck).value, 0.5);
  EXPECT_DOUBLE_EQ(watch.error(Joint::kHead).value, 0);
  EXPECT_THAT(watch.jointsText(), HasSubstr("Neck        11.5 deg at   1.00 s   load  50.0 % at   1.00 s\n"));
}

TEST(MotionWatch, IgnoresStaleAndLimpJoints) {
  MotionWatch watch;
  Sensors seen = following();
  auto &neck = seen.joint[index(Joint::kNeck)], &head = seen.joint[index(Joint::kHead)];
  neck.motion.missed();
  neck.position = Rad{1};
  head.commanded = Rad{};
  watch.update(seen, 1);
  EXPECT_TRUE(std::isnan(watch.error(Joint::kNeck).value));
  EXPECT_TRUE(std::isnan(watch.error(Joint::kHead).value));
  EXPECT_THAT(watch.jointsText(), HasSubstr("Neck       not measured   load not measured\n"));
}

TEST(MotionWatch, ReportsFaultsLimitsAndBusErrorsSinceTheFirstUpdate) {
  MotionWatch watch;
  Sensors seen = following();
  seen.safety.limit_hits[0] = 7;
  seen.link.retries = 3;
  watch.update(seen, 0);
  EXPECT_EQ(watch.faultsText(), MotionWatch::kNoFaults);
  seen.safety.limit_hits[0] = 9;
  seen.link.retries = 4;
  seen.safety.active.set(2);
  watch.update(seen, 1);
  seen.safety.active.reset();
  watch.update(seen, 2);
  EXPECT_EQ(watch.faultsText(), "faults (docs/faults.md): " + std::string{kFaultTable[2].name} +
                                    "\ngoals cut by the safety layer: 2 position\nbus and loop: 1 retries\n");
}

}  // namespace
}  // namespace darwinop::motion
