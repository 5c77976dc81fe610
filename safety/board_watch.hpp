// The board's view of the robot as a whole: is it there, has it power, does it lie on the floor?
#pragma once

#include <array>
#include <cstdint>

#include "core/sensors.hpp"
#include "safety/config.hpp"
#include "safety/debounce.hpp"

namespace darwinop::safety {

class BoardWatch {
 public:
  explicit BoardWatch(const Config& config);

  /// `waits`: the robot waits for a person, who may press START.
  void update(const BoardSensors& seen, bool waits, Nanos dt) noexcept;

  /// The board answered at most kAnswerPatience cycles ago.
  [[nodiscard]] bool online() const noexcept { return online_; }
  [[nodiscard]] bool answersNow() const noexcept { return answers_now_; }
  /// It has not for longer, counted from the first cycle.
  [[nodiscard]] bool silent() const noexcept { return missed_ > kAnswerPatience; }
  /// The servos have power, for so long.
  [[nodiscard]] bool powered() const noexcept { return powered_; }
  [[nodiscard]] Nanos poweredFor() const noexcept { return powered_for_; }
  /// The servos had power and lost it; two answers in a row say so.
  [[nodiscard]] bool powerLost() const noexcept { return online_ && lost_; }
  /// Two answers in a row say that servo power is off, whether it was on or not.
  [[nodiscard]] bool powerOff() const noexcept { return power_off_.on(); }
  /// True in the cycle in which that is first known.
  [[nodiscard]] bool powerLostNow() const noexcept { return lost_now_; }
  /// Servo power has to be switched on.
  [[nodiscard]] bool wantsPower() const noexcept {
    return online_ && !power_bit_ && (lost_ || !had_power_) && !withheld_;
  }
  /// Power was lost too often: it stays off until allowPower().
  [[nodiscard]] bool powerWithheld() const noexcept { return withheld_; }
  /// A person has acted.
  void allowPower() noexcept;
  [[nodiscard]] bool batteryLow() const noexcept { return low_.on(); }
  [[nodiscard]] bool batteryEmpty() const noexcept { return empty_.on(); }
  [[nodiscard]] bool fell() const noexcept { return fell_.on(); }
  [[nodiscard]] bool released() const noexcept { return released_.on(); }
  /// True in the cycle in which a press of START that began while the robot waited for a person has lasted long enough.
  [[nodiscard]] bool startPressed() const noexcept { return start_now_; }

  // Servo power that was lost is switched on again without a person at most so often in so long. A press of RESET or a
  // supply that dipped once needs one; a loose battery connector or a short circuit loses it again within seconds, and
  // every new try draws the inrush current of 20 servos. Without a bound the virtual board was re-powered after each of
  // 30 presses in a row. Not measured on a robot.
  static constexpr std::size_t kRepowers = 3;
  static constexpr Nanos kRepowerWindow{std::chrono::seconds{60}};

 private:
  void watchPower(const BoardSensors& seen) noexcept;
  void losePower() noexcept;
  void watchStart(bool pressed, bool waits, Nanos dt) noexcept;
  void watchTilt(const BoardSensors& seen, Nanos dt) noexcept;

  const Config& config_;
  std::uint32_t missed_ = 0;
  bool online_ = false, answers_now_ = false, powered_ = false, had_power_ = false, power_bit_ = false;
  bool lost_ = false, lost_now_ = false, withheld_ = false;
  bool start_was_up_ = false, start_now_ = false;
  Nanos powered_for_{0};
  std::array<Nanos, kRepowers> since_{};  // since the last times that power was lost, latest first
  Confirm power_off_;
  Debounce low_, empty_, fell_, released_, start_;
};

/// Angle between the trunk and the vertical, deg; NaN when the measurement cannot tell (unknown, or free fall).
[[nodiscard]] double tiltDegrees(const BoardSensors& seen) noexcept;

}  // namespace darwinop::safety
