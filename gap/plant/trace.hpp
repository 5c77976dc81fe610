// Result and options of a simulated log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "gap/plant/place.hpp"

namespace darwinop::gap {

/// A column of a log, and where it is measured.
struct Signal {
  enum class Kind : std::uint8_t { kPosition, kSpeed, kLoad, kSupply, kGyro, kAccelerometer };
  Kind kind = Kind::kPosition;
  std::string_view unit;
  Place place = {};
};

/// Columns of the first joint in a trace, and their indices in Plant::signals().
inline constexpr std::size_t kPositionSignal = 0;  // rad, of the encoder
inline constexpr std::size_t kSpeedSignal = 1;     // rad/s, of the arm; true
inline constexpr std::size_t kLoadSignal = 2;      // as the servo reports it, -1 to 1
inline constexpr std::size_t kSupplySignal = 3;    // V, at the servo
inline constexpr std::size_t kJointSignals = 4;

/// A column for each of Plant::signals(), one value for each row of the log. Quantised only with a Disturbance.
struct Trace {
  std::vector<std::vector<double>> columns;

  std::vector<double>& operator[](std::size_t signal) { return columns[signal]; }
  const std::vector<double>& operator[](std::size_t signal) const { return columns[signal]; }
};

/// Run-to-run noise of a bench: torque, supply and encoder.
struct Disturbance {
  std::uint64_t seed = 0;
  double torque_nm = 0.002, torque_time_s = 0.02;  // standard deviation and correlation time
  double supply_v = 0.03, supply_time_s = 0.05;
  double encoder_ticks = 0.3;  // before rounding
};

/// Without disturbance the encoder is exact, so that the result is a smooth function of the hypothesis. With one,
/// registers round as the real ones do.
struct RollOutOptions {
  const Disturbance* disturbance = nullptr;
  // Mechanical steps in a period of the firmware. 0: as many as the law needs, and a firmware faster than 0.5 ms is
  // simulated as one of at most that, whose encoder looks half of the difference ahead.
  int steps_per_period = 0;
};

}  // namespace darwinop::gap
