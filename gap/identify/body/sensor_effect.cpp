#include "gap/identify/body/sensor_effect.hpp"

#include <algorithm>
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

bool SensorFit::has(SensorEffect::Number number) const {
  return std::ranges::find(effects, number, &SensorEffect::number) != effects.end();
}

bool SensorFit::extends(const SensorFit& other) const {
  return effects.size() > other.effects.size() && std::ranges::all_of(other.effects, [&](const SensorEffect* effect) {
           return std::ranges::find(effects, effect) != effects.end();
         });
}

}  // namespace darwinop::gap
