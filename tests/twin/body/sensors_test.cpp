// Sensors of the body: gyroscope and accelerometer (axes, signs, free fall, scale, bias, noise), buttons, servo
// sensors.
#include "twin/body/support.hpp"

namespace darwinop::twin::test {
namespace {

// In free fall, upright, rotating about the trunk's axes: left, up, forward.
void spin(RobotBody& body, const Vec& rate) {
  body.place(Pose{});
  lift(body);
  mju_copy3(trunkQvel(body) + 3, rate.data());
}
// Nearly rigid joints: the robot rotates as one body.
Model stiff() {
  return modelWith(50);
}

TEST(Accelerometer, ReadsOneGravityUpwardsAtRest) {
  RobotBody body{stiff()};
  body.place(Pose{});
  run(body, limp(), 1);
  const auto& measured = body.state().accel_m_s2;
  // Contact compliance tilts the robot by less than half a degree.
  EXPECT_NEAR(measured[0], 0, 0.08);
  EXPECT_NEAR(measured[1], 0, 0.08);
  EXPECT_NEAR(measured[2], kGravity, 0.01);
}

TEST(Accelerometer, ReadsZeroInFreeFall) {
  RobotBody body{stiff()};
  body.place(Pose{});
  lift(body);
  run(body, limp(), 0.5);
  for (const double measured : body.state().accel_m_s2) EXPECT_NEAR(measured, 0, 1e-6);
}

// A play somewhere makes the physics steps finer than the firmware's cycle.
TEST(Accelerometer, MeasuresAnImpactWithinItsCycleWithAndWithoutPlay) {
  for (const bool has_play : {false, true}) {
    Model model = stiff();
    if (has_play) model.effects.push_back({findEffect("backlash"), {0.01}, Joint::kNeck});
    RobotBody body{model};
    body.place(Pose{});
    lift(body);
    run(body, limp(), 0.1);
    trunkQvel(body)[2] += 0.01;  // m/s; upwards
    run(body, limp(), 0.001);
    EXPECT_NEAR(body.state().accel_m_s2[2], 10, 0.5) << has_play;
    run(body, limp(), 0.001);
    EXPECT_NEAR(body.state().accel_m_s2[2], 0, 0.5) << has_play;
  }
}

TEST(Accelerometer, PointsItsForwardAxisDownFaceDown) {
  RobotBody body{stiff()};
  body.place(Pose{}, kPi / 2);  // pitched forward by 90 degrees
  run(body, limp(), 2);
  EXPECT_LT(body.state().accel_m_s2[1], -0.9 * kGravity);
}

TEST(Accelerometer, PointsItsRightAxisDownOnTheRightSide) {
  RobotBody body{stiff()};
  hangUp(body);
  // Turned about the forward axis by a right angle: the right side is down.
  const mjtNum forward[3] = {1, 0, 0};
  mjtNum turn[4], upright[4];
  mju_axisAngle2Quat(turn, forward, kPi / 2);
  mju_copy4(upright, trunkQpos(body) + 3);
  mju_mulQuat(trunkQpos(body) + 3, turn, upright);
  run(body, limp(), 0.1);
  EXPECT_NEAR(body.state().accel_m_s2[0], -kGravity, 0.01);
  EXPECT_NEAR(body.state().accel_m_s2[2], 0, 0.01);
}

TEST(Accelerometer, MeasuresCentripetalAccelerationAtItsSite) {
  // Rotation about the vertical axis through the trunk's centre of mass: only the site matters, 10 mm behind the
  // origin.
  RobotBody body{stiff()};
  hangUp(body);
  const double rate = 10;
  mju_copy3(trunkQvel(body) + 3, Vec{0, rate, 0}.data());
  run(body, limp(), 0.01);
  EXPECT_NEAR(body.state().accel_m_s2[1], 0.01 * rate * rate, 0.02);  // towards the axis, which is in front
  EXPECT_NEAR(body.state().accel_m_s2[0], 0, 0.02);
}

struct SpinRow {
  const char* motion;
  Vec rate;  // of the trunk: left, up, forward
  std::size_t axis;
  double measured;
};
TEST(Gyro, HasTheBoardsAxesAndSigns) {
  // A positive rate about the trunk's left axis pitches forward, about its forward axis rolls right.
  for (const auto& [motion, rate, axis, measured] :
       {SpinRow{"pitching backward", {-1, 0, 0}, 1, 1}, SpinRow{"pitching forward", {1, 0, 0}, 1, -1},
        SpinRow{"rolling to the left", {0, 0, -1}, 0, 1}, SpinRow{"turning to the left", {0, 1, 0}, 2, 1}}) {
    RobotBody body{stiff()};
    spin(body, rate);
    const double before = body.upright();
    run(body, limp(), 0.001);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(body.state().gyro_rad_s[k], k == axis ? measured : 0, 0.01) << motion << " axis " << k;
    EXPECT_NEAR(before, 1, 1e-9);
  }
}

TEST(Gyro, PitchingForwardBringsTheHeadForward) {
  RobotBody body{stiff()};
  spin(body, {1, 0, 0});
  run(body, limp(), 0.5);
  const mjData& d = *body.mujocoData();
  EXPECT_GT(d.xpos[3 * idOf(body, mjOBJ_BODY, "Head")], d.xpos[3 * idOf(body, mjOBJ_BODY, "FootL")] + 0.05);
  EXPECT_LT(body.state().gyro_rad_s[1], -0.5);
}

TEST(Imu, SaturatesAtItsRange) {
  RobotBody body{stiff()};
  spin(body, {0, 40, 0});
  run(body, limp(), 0.001);
  EXPECT_EQ(body.state().gyro_rad_s[2], 34.907);
}

TEST(Imu, ShowsScaleAndBiasOfTheModel) {
  Model model = stiff();
  model.imu.gyro_scale = {1, 1, -0.5};
  model.imu.gyro_bias_rad_s = {0.1, 0, 0};
  model.imu.accel_bias_m_s2 = {0, 0.3, 0};
  model.imu.accel_scale = {1, 1, 2};
  RobotBody body{model};
  spin(body, {0, 2, 0});
  run(body, limp(), 0.001);
  EXPECT_NEAR(body.state().gyro_rad_s[0], 0.1, 0.01);
  EXPECT_NEAR(body.state().gyro_rad_s[2], -1, 0.01);
  body.place(Pose{});
  run(body, limp(), 1);
  EXPECT_NEAR(body.state().accel_m_s2[1], 0.3, 0.08);
  EXPECT_NEAR(body.state().accel_m_s2[2], 2 * kGravity, 0.02);
}

TEST(Imu, NoiseHasTheConfiguredDeviationAndZeroMean) {
  Model model = stiff();
  model.imu.gyro_noise_rad_s = 0.05;
  model.imu.accel_noise_m_s2 = 0.4;
  RobotBody body{model};
  body.place(Pose{});
  run(body, limp(), 1);
  constexpr int kSamples = 2000;
  double sum = 0, squares = 0, accel_sum = 0, accel_squares = 0;
  for (int i = 0; i < kSamples; ++i) {
    body.step(kStep, limp());
    const double gyro = body.state().gyro_rad_s[0], accel = body.state().accel_m_s2[2] - kGravity;
    sum += gyro;
    squares += gyro * gyro;
    accel_sum += accel;
    accel_squares += accel * accel;
  }
  // Four standard errors of 2000 samples.
  EXPECT_NEAR(sum / kSamples, 0, 4 * 0.05 / std::sqrt(kSamples));
  EXPECT_NEAR(std::sqrt(squares / kSamples), 0.05, 4 * 0.05 / std::sqrt(2.0 * kSamples));
  EXPECT_NEAR(accel_sum / kSamples, 0, 4 * 0.4 / std::sqrt(kSamples) + 0.01);
  EXPECT_NEAR(std::sqrt(accel_squares / kSamples), 0.4, 4 * 0.4 / std::sqrt(2.0 * kSamples));
}

TEST(Buttons, AreWhatWasPressed) {
  RobotBody body{modelWith()};
  EXPECT_EQ(body.state().buttons, 0);
  body.press(2);
  run(body, limp(), 0.002);
  EXPECT_EQ(body.state().buttons, 2);
}

TEST(ServoSensors, ReportSupplyAndTemperature) {
  RobotBody body{modelWith(0.1)};
  Drives drives = limp();
  drives[index(Joint::kNeck)].supply_v = 11.1;
  run(body, drives, 0.01);
  EXPECT_NEAR(body.state().joint[index(Joint::kNeck)].supply_v, 11.1, 1e-9);
  EXPECT_NEAR(body.state().joint[index(Joint::kNeck)].temperature_c, 25, 0.01);
}

}  // namespace
}  // namespace darwinop::twin::test
