// Conditions derived from the board's readings: online, servo power, battery, tilt, buttons. Without a board from the
// servos' readings, as far as they show them: no tilt, no buttons, and servo power is unknown.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "core/sensors.hpp"
#include "safety/config.hpp"
#include "safety/debounce.hpp"
#include "safety/supply_watch.hpp"

namespace darwinop::safety {

class BoardWatch {
 public:
  explicit BoardWatch(const Config& config);

  /// Once a cycle. `waits`: the robot waits for a person; only then does START count.
  void update(const Sensors& seen, bool waits, Nanos dt) noexcept;

  /// Without a board: goals go out to these joints.
  void noteGoals(const std::bitset<kJoints>& written) noexcept { supply_.noteGoals(written); }

  /// There is no board: the functions below that name it are about the servo that is read first.
  [[nodiscard]] bool absent() const noexcept { return absent_; }
  /// The board replied at most kAnswerPatience cycles ago.
  [[nodiscard]] bool online() const noexcept { return online_; }
  [[nodiscard]] bool answersNow() const noexcept { return answers_now_; }
  /// The board has not replied for more than kAnswerPatience cycles, counted from the first cycle.
  [[nodiscard]] bool silent() const noexcept { return missed_ > kAnswerPatience; }
  /// The servos have power; for how long. Without a board: they reply.
  [[nodiscard]] bool powered() const noexcept { return powered_; }
  [[nodiscard]] Nanos poweredFor() const noexcept { return powered_for_; }
  /// The servos had power and lost it; confirmed by two replies in a row.
  [[nodiscard]] bool powerLost() const noexcept { return online_ && lost_; }
  /// Servo power is off, by two replies in a row, whether it was on before or not.
  [[nodiscard]] bool powerOff() const noexcept { return power_off_.on(); }
  /// True in the cycle that confirms the loss of power. Without a board: that shows that it was lost and is back.
  [[nodiscard]] bool powerLostNow() const noexcept { return lost_now_; }
  /// Servo power is to be switched on.
  [[nodiscard]] bool wantsPower() const noexcept {
    return !absent_ && online_ && !power_bit_ && (lost_ || !had_power_) && !withheld_;
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

  // Lost servo power is switched on automatically at most kRepowers times in kRepowerWindow. RESET or a single supply
  // dip needs one attempt; with a loose battery connector or a short circuit power is lost again within seconds, and
  // every attempt draws the inrush current of 20 servos. Values not measured on a robot.
  static constexpr std::size_t kRepowers = 3;
  static constexpr Nanos kRepowerWindow{std::chrono::seconds{60}};

 private:
  [[gnu::cold, gnu::noinline]] void updateWithoutBoard(const Sensors& seen, Nanos dt) noexcept;
  void noteReply(const Freshness& link) noexcept;
  void watchBattery(double volt, Nanos dt) noexcept;
  void watchPower(const BoardSensors& seen) noexcept;
  void losePower() noexcept;
  void watchStart(bool pressed, bool waits, Nanos dt) noexcept;
  void watchTilt(const BoardSensors& seen, Nanos dt) noexcept;

  const Config& config_;
  std::uint32_t missed_ = 0;
  bool online_ = false, answers_now_ = false, powered_ = false, had_power_ = false, power_bit_ = false;
  bool lost_ = false, lost_now_ = false, withheld_ = false, absent_ = false;
  bool start_was_up_ = false, start_now_ = false;
  Nanos powered_for_{0};
  std::array<Nanos, kRepowers> since_{};  // time since the last losses of power, latest first
  Confirm power_off_;
  Debounce low_, empty_, fell_, released_, start_;
  SupplyWatch supply_;
};

/// Angle between the trunk and the vertical, deg; NaN if acceleration is unknown or too small (free fall).
[[nodiscard]] double tiltDegrees(const BoardSensors& seen) noexcept;

}  // namespace darwinop::safety
