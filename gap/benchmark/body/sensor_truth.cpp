#include "gap/benchmark/body/sensor_truth.hpp"

#include <cmath>

namespace darwinop::gap {

void applyTo(ImuDeviation& imu, const SensorEffect& effect, const std::vector<double>& values) {
  RestingImu::Deviation& of = effect.sensor == ImuSensor::kGyro ? imu.gyro : imu.accel;
  const Eigen::Vector3d vector{values.at(0), values.at(1), values.at(2)};
  if (effect.number == SensorEffect::Number::kBias) of.bias += vector;
  if (effect.number == SensorEffect::Number::kScale) of.scale = vector;
  if (effect.number == SensorEffect::Number::kRotation) of.rotation = vector;
  if (effect.number != SensorEffect::Number::kMap) return;
  of.map.setZero();
  for (Eigen::Index i = 0; i < 3; ++i)
    of.map(i, static_cast<Eigen::Index>(std::abs(vector[i])) - 1) = vector[i] > 0 ? 1 : -1;
}

}  // namespace darwinop::gap
