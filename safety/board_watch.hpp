// What the board tells about the robot as a whole: is it there, has it power, does it lie on the floor?
#pragma once

#include <cstdint>

#include "core/sensors.hpp"
#include "safety/config.hpp"
#include "safety/debounce.hpp"

namespace darwinop::safety {

class BoardWatch {
 public:
  explicit BoardWatch(const Config& config);

  void update(const BoardSensors& seen, Nanos dt) noexcept;

  /// The board answered at most 5 cycles ago.
  [[nodiscard]] bool online() const noexcept { return online_; }
  [[nodiscard]] bool answersNow() const noexcept { return answers_now_; }
  /// It has not for more than 5 cycles, counted from the first cycle.
  [[nodiscard]] bool silent() const noexcept { return missed_ > kPatience; }
  /// The servos have power, for so long.
  [[nodiscard]] bool powered() const noexcept { return powered_; }
  [[nodiscard]] Nanos poweredFor() const noexcept { return powered_for_; }
  /// The servos had power and lost it.
  [[nodiscard]] bool powerLost() const noexcept { return online_ && had_power_ && !powered_; }
  /// The board says now that servo power is off and can be told to switch it on.
  [[nodiscard]] bool wantsPower() const noexcept { return online_ && !power_bit_; }
  [[nodiscard]] bool batteryLow() const noexcept { return low_.on(); }
  [[nodiscard]] bool batteryEmpty() const noexcept { return empty_.on(); }
  [[nodiscard]] bool fell() const noexcept { return fell_.on(); }
  [[nodiscard]] bool released() const noexcept { return released_.on(); }

 private:
  static constexpr std::uint32_t kPatience = 5;  // cycles; a lost reply or two is normal on this bus

  void watchPower(const BoardSensors& seen) noexcept;
  void watchTilt(const BoardSensors& seen, Nanos dt) noexcept;

  double battery_low_, battery_empty_, fall_tilt_;
  bool button_counts_;
  std::uint32_t missed_ = 0;
  bool online_ = false, answers_now_ = false, powered_ = false, had_power_ = false, power_bit_ = false;
  Nanos powered_for_{0};
  Confirm power_off_;
  Debounce low_, empty_, fell_, released_;
};

/// Angle between the trunk and the vertical, deg; NaN when the measurement cannot tell (unknown, or free fall).
[[nodiscard]] double tiltDegrees(const BoardSensors& seen) noexcept;

}  // namespace darwinop::safety
