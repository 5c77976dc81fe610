// Resolution of the registers that a servo reports.
#pragma once

#include "core/servo_limits.hpp"
#include "gap/case/case.hpp"
#include "twin/servo/parameters.hpp"

namespace darwinop::gap {

/// Load 0.1 %, as a fraction; voltage in V; speed in rad/s.
inline constexpr double kLoadStep = 0.001, kVoltStep = 0.1, kSpeedStep = kRadPerSecPerCount;
/// The servo computes its speed from positions this many seconds apart.
inline constexpr double kSpeedSpan = 0.024;

/// Step of the loads of a log: that of the register, or a coarser one in which they were written.
double loadStepOf(const Trajectory& log);

/// Standard deviation of rounding to steps of 1: 1 / sqrt(12).
inline constexpr double kRoundingSigma = 0.28867513459481288;

/// Standard deviation of one reported position, rad: rounding and noise of the encoder.
double readingSigma(const twin::ServoParameters& servo);

}  // namespace darwinop::gap
