// An effect of the resting inertial sensor, in the robot that is simulated.
#pragma once

#include <vector>

#include "gap/identify/body/sensor_effect.hpp"
#include "gap/plant/body/moving_imu.hpp"

namespace darwinop::gap {

/// `values`: of x, y and z.
void applyTo(ImuDeviation& imu, const SensorEffect& effect, const std::vector<double>& values);

}  // namespace darwinop::gap
