// The gap on held-out recordings: clamped ones and those on the floor, sample by sample.
#include "gap/identify/body/held_out_gap.hpp"

#include <gmock/gmock.h>

#include "gap/body/moving_robot.hpp"
#include "gap/body/standing_robot.hpp"
#include "gap/identify/body/compared_models.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

/// All logs of both. The clamped sensors read what a turned trunk does.
BodyCase both(BodyCase clamped, const BodyCase& on_floor) {
  const RestingImu imu{clamped.joints.model};
  for (BodyLog& log : clamped.logs) {
    const Eigen::Vector3d up{(*log.up)[0], (*log.up)[1], (*log.up)[2]};
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t row = 0; row < log.rows(); ++row) {
        const double sign = row % 2 == 0 ? 1 : -1;
        log.gyro_rad_s[axis][row] = sign * 0.03;
        log.accel_m_s2[axis][row] =
            imu.reading(ImuSensor::kAccelerometer, up)[static_cast<Eigen::Index>(axis)] + sign * 0.04;
      }
  }
  for (const BodyLog& log : on_floor.logs) clamped.logs.push_back(log);
  for (const Trajectory& of : on_floor.joints.logs) clamped.joints.logs.push_back(of);
  return clamped;
}

void expectNoise(const GapErrors& of, const GapErrors& floor) {
  EXPECT_NEAR(of.joints / floor.joints, 1, 0.2);
  EXPECT_NEAR(of.gyro / floor.gyro, 1, 0.2);
  EXPECT_NEAR(of.accel / floor.accel, 1, 0.25);
}

TEST(HeldOutGap, OfARightModelIsTheNoise) {
  const HeldOutGap gap = heldOutGap(both(movingRobot(shippedRobot()), standingRobot(shippedOnFloor())),
                                    shippedOnFloor(), shippedOnFloor());
  EXPECT_NEAR(1e3 * gap.floor.joints, 0.66, 0.1) << "an encoder that rounds, and repeats of a motion";
  expectNoise(gap.before, gap.floor);
  expectNoise(gap.after, gap.floor);
}

TEST(HeldOutGap, AFloorThatSlopesIsInTheGapBeforeAndNotInTheGapAfter) {
  FloorModel hidden = shippedOnFloor();
  hidden.robot.floor.tilt_rad = {0.03, -0.01};
  const HeldOutGap gap = heldOutGap(both(movingRobot(shippedRobot()), standingRobot(hidden)), shippedOnFloor(), hidden);
  EXPECT_GT(gap.before.joints, 1.2 * gap.floor.joints);
  EXPECT_GT(gap.before.accel, 2 * gap.floor.accel);
  expectNoise(gap.after, gap.floor);
}

TEST(ComparedModels, TheOneThatHasTheFrictionIsBetterOnHeldOutLogs) {
  BodyHypothesis hidden = shippedRobot();
  const twin::EffectInfo* const viscous = twin::findEffect("viscous");
  hidden.servos.with(*viscous, {.kind = Place::Kind::kJoint, .name = "Neck"}).values = {0.08};
  const BodyCase given = movingRobot(hidden);
  const twin::Model before = given.joints.model;
  twin::Model after = before;
  after.effects.push_back({.info = viscous, .values = {0.08}, .joint = Joint::kNeck});
  const HeldOutGap better = compareModels(given, before, after), worse = compareModels(given, after, before);
  EXPECT_GT(better.before.joints, 1.2 * better.floor.joints);
  EXPECT_NEAR(better.after.joints / better.floor.joints, 1, 0.2);
  EXPECT_EQ(better.before.joints, worse.after.joints);
  EXPECT_EQ(comparedJson(given, better)["gap_score_after"]["joints_mrad"], 1e3 * better.after.joints);
}

TEST(ComparedModels, WithoutAHeldOutLogNothingIsCompared) {
  BodyCase given = movingRobot(shippedRobot());
  for (BodyLog& log : given.logs) log.held_out = false;
  for (Trajectory& log : given.joints.logs) log.held_out = false;
  const twin::Model model = given.joints.model;
  EXPECT_THROW((void)compareModels(given, model, model), std::runtime_error);
}

TEST(HeldOutGap, AFrictionIsInTheGapOfClampedLogs) {
  FloorModel hidden = shippedOnFloor();
  hidden.robot.robot.servos.with(*twin::findEffect("viscous"), {.kind = Place::Kind::kJoint, .name = "Neck"}).values = {
      0.08};
  const HeldOutGap gap =
      heldOutGap(both(movingRobot(hidden.robot.robot), standingRobot(hidden)), shippedOnFloor(), hidden);
  EXPECT_GT(gap.before.joints, 1.2 * gap.floor.joints);
  expectNoise(gap.after, gap.floor);
}

TEST(HeldOutGap, OfASimulationThatFailsIsNotKnown) {
  FloorModel wrong = shippedOnFloor();
  wrong.robot.engine.drop_m = 1e12;  // farther than MuJoCo simulates
  const HeldOutGap gap =
      heldOutGap(both(movingRobot(shippedRobot()), standingRobot(shippedOnFloor())), shippedOnFloor(), wrong);
  EXPECT_TRUE(std::isfinite(gap.before.joints));
  EXPECT_TRUE(std::isnan(gap.after.joints)) << gap.after.joints;
}

TEST(HeldOutGap, WithoutASimulationJointsAreNotKnown) {
  const HeldOutGap gap = heldOutGapAtRest(both(movingRobot(shippedRobot()), standingRobot(shippedOnFloor())), {});
  EXPECT_TRUE(std::isnan(gap.before.joints));
  EXPECT_NEAR(gap.before.gyro, 0.03, 1e-6);
  EXPECT_NEAR(gap.after.accel, 0.04, 1e-6);
}

}  // namespace
}  // namespace darwinop::gap
