// A deviation of the inertial sensor that was found means the same as the key of [imu] that it becomes.
#include <gtest/gtest.h>

#include "gap/plant/body/resting_imu.hpp"
#include "twin/body/robot_body.hpp"

namespace darwinop::gap {
namespace {

twin::Model shipped() {
  return twin::readModel(twin::findModel("darwin-op"));
}

/// What the twin's clamped sensor reads.
Eigen::Vector3d twinReading(const twin::Model& model, const Axes& up) {
  twin::RobotBody body{model, {.clamped_up = up}};
  body.step(Nanos{5'000'000}, {});
  const auto& read = body.state().accel_m_s2;
  return {read[0], read[1], read[2]};
}

void expectSame(const RestingImu::Deviation& found, const twin::Model& model) {
  for (const Axes& up : {Axes{0, 1, 0}, Axes{-1, 0, 0}, Axes{0, 0, -1}, Axes{0.48, 0.6, 0.64}}) {
    const Eigen::Vector3d direction{up[0], up[1], up[2]};
    const Eigen::Vector3d expected = RestingImu{shipped()}.reading(ImuSensor::kAccelerometer, direction, found),
                          of_twin = twinReading(model, up),
                          of_model = RestingImu{model}.reading(ImuSensor::kAccelerometer, direction);
    EXPECT_LT((of_twin - expected).norm(), 1e-6) << of_twin.transpose() << " and " << expected.transpose();
    EXPECT_LT((of_model - expected).norm(), 1e-9) << of_model.transpose() << " and " << expected.transpose();
  }
}

TEST(SensorKeys, ARotationIsTheMounting) {
  RestingImu::Deviation found;
  found.rotation = {0.1, -0.2, 0.3};
  twin::Model model = shipped();
  model.imu.mounting_rad = {0.1, -0.2, 0.3};
  expectSame(found, model);
}

TEST(SensorKeys, AMapIsTheAxesBeforeScaleAndBias) {
  RestingImu::Deviation found;
  found.map << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // x reads minus y, y reads x
  found.scale = {1.1, 1, 1}, found.bias = {0, 0.2, 0};
  twin::Model model = shipped();
  model.imu.accel_axes = {-2, 1, 3};
  model.imu.accel_scale = {1.1, 1, 1};
  model.imu.accel_bias_m_s2 = {0, 0.2, 0};
  expectSame(found, model);
}

}  // namespace
}  // namespace darwinop::gap
