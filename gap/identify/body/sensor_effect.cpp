#include "gap/identify/body/sensor_effect.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/thresholds.hpp"

namespace darwinop::gap {

std::span<const SensorEffect> sensorEffects() {
  using Kind = SensorEffect::Number;
  static constexpr std::array kEffects{
      SensorEffect{"gyro_bias", "gyro", "bias", "rad/s", ImuSensor::kGyro, Kind::kBias, thresholds::kGyroBias},
      SensorEffect{"accel_bias", "accelerometer", "bias", "m/s2", ImuSensor::kAccelerometer, Kind::kBias,
                   thresholds::kAccelBias},
      SensorEffect{"accel_scale", "accelerometer", "scale", "", ImuSensor::kAccelerometer, Kind::kScale,
                   thresholds::kAccelScale},
      SensorEffect{"imu_mounting", "imu", "rotation", "rad", ImuSensor::kAccelerometer, Kind::kRotation,
                   thresholds::kImuRotation},
      SensorEffect{"accel_axes", "accelerometer", "map", "", ImuSensor::kAccelerometer, Kind::kMap,
                   std::numeric_limits<double>::infinity()}};
  return kEffects;
}

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

bool SensorFit::has(SensorEffect::Number number) const {
  return std::ranges::find(effects, number, &SensorEffect::number) != effects.end();
}

bool SensorFit::extends(const SensorFit& other) const {
  return effects.size() > other.effects.size() && std::ranges::all_of(other.effects, [&](const SensorEffect* effect) {
           return std::ranges::find(effects, effect) != effects.end();
         });
}

}  // namespace darwinop::gap
