// Mean reading of the inertial sensors of a robot at rest, with the error of that mean.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <span>

#include "runtime/robot_link.hpp"

namespace darwinop::calibrate {

using Axes = std::array<double, 3>;

struct StillReading {
  Axes gyro{}, gyro_sigma{};    // rad/s
  Axes accel{}, accel_sigma{};  // m/s2
  std::size_t samples = 0;
  bool moved = false;  // faster or more unsteadily than a robot that rests
};

/// `step`: of the register. The error of the mean counts the autocorrelation, by the means of ten parts. Where noise is
/// far below a step every sample is rounded alike, and the mean is no finer than a sample.
void meanOf(std::span<const double> samples, double step, double& mean, double& sigma);

/// Reads for `time`. Nothing if the loop ends, `stop` becomes true, or the board answers in less than half of the
/// cycles.
std::optional<StillReading> readAtRest(runtime::RobotLink& link, Nanos time, const std::atomic<bool>& stop);

}  // namespace darwinop::calibrate
