// How the inertial sensors are mounted in the trunk of a model, and its gravity.
#pragma once

#include <array>

#include "twin/model/model.hpp"

namespace darwinop::twin {

/// Rows: the sensor's x, y and z in the trunk's frame (left, up, forward).
using MountingMatrix = std::array<std::array<double, 3>, 3>;

struct ImuAxes {
  MountingMatrix gyro{}, accelerometer{};
  double gravity_m_s2 = 0;
};

/// Throws std::runtime_error with the body's file and the reason.
ImuAxes imuAxesOf(const Model& model);

}  // namespace darwinop::twin
