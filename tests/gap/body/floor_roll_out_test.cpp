// The simulation of the whole robot on the floor: its clock, and how it lies.
#include <gtest/gtest.h>

#include "gap/body/standing_robot.hpp"

namespace darwinop::gap {
namespace {

/// A recording on the floor, simulated with this step and period.
FloorTrace simulatedWith(double step_s, double period_s) {
  BodyCase given;
  given.joints.model = twin::readModel(twin::findModel("darwin-op"));
  given.joints.model.body.step_s = step_s, given.joints.model.servo.firmware_period_s = period_s;
  addRecording(given, BodySetup::kFloor, 40, false);
  return rollOut(given, 0, {.robot = {bodyBaselineOf(given), {}}, .floor = {}});
}

TEST(FloorRollOut, TheStepOfThePhysicsAndThePeriodOfTheFirmwareDoNotChangeTheSpeed) {
  const FloorTrace usual = simulatedWith(0.001, 0.001);
  for (const auto& [step_s, period_s] : {std::pair{0.0005, 0.001}, {0.0004, 0.001}, {0.002, 0.001}, {0.001, 0.0005}}) {
    const FloorTrace other = simulatedWith(step_s, period_s);
    const Eigen::MatrixXd off = other.position_rad - usual.position_rad;
    EXPECT_LT(off.cwiseAbs().maxCoeff(), 0.005) << "rad; step " << step_s << " s, period " << period_s << " s";
  }
}

TEST(FloorRollOut, ARobotIsLaidOnTheSideOfItsRecording) {
  BodyCase given;
  given.joints.model = twin::readModel(twin::findModel("darwin-op"));
  addRecording(given, BodySetup::kLying, 10, false);
  for (const auto& [side, sign] : {std::pair{"left", 1.0}, {"right", -1.0}}) {
    given.logs[0].lies_on = side;
    const FloorTrace trace = rollOut(given, 0, shippedOnFloor().robot);
    // To its right, in the first 0.2 s: then it rolls over, as it has one arm under it.
    EXPECT_GT(sign * trace.accel_m_s2.col(0).head(200).mean(), 5) << side;
  }
}

}  // namespace
}  // namespace darwinop::gap
