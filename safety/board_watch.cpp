// Conditions derived from the board's readings.
#include "safety/board_watch.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::safety {
namespace {

using std::chrono::milliseconds;

constexpr double kTiltHysteresis = 15;  // deg
constexpr double kLeastGravity = 3.0;   // m/s2; below this (free fall, impact) the direction is meaningless
constexpr std::uint8_t kModeButton = 1, kStartButton = 2;
constexpr Nanos kPress{milliseconds{250}};  // shorter presses may be accidental

}  // namespace

double tiltDegrees(const BoardSensors& seen) noexcept {
  const auto& a = seen.accelerometer;
  const double length = std::hypot(a[0].value, a[1].value, a[2].value);
  if (!(length >= kLeastGravity) || !std::isfinite(length)) return kUnknown;
  return std::acos(std::clamp(a[2].value / length, -1.0, 1.0)) / kRadPerDegree;
}

BoardWatch::BoardWatch(const Config& config)
    : config_{config},
      had_power_{config.held_before},
      low_{milliseconds{2000}, milliseconds{2000}},
      empty_{milliseconds{2000}, milliseconds{2000}},
      fell_{milliseconds{500}, milliseconds{500}},
      released_{kPress, milliseconds{0}},
      start_{kPress, milliseconds{0}},
      supply_{config.held_before} {
  allowPower();
}

inline void BoardWatch::noteReply(const Freshness& link) noexcept {
  answers_now_ = link.fresh();
  if (link.ever())
    missed_ = link.age;
  else if (missed_ <= kAnswerPatience)
    ++missed_;
  online_ = link.ever() && missed_ <= kAnswerPatience;
}

inline void BoardWatch::watchBattery(double volt, Nanos dt) noexcept {
  // NaN fails every comparison: unknown is not a fault
  low_.update(volt<config_.battery_low, volt> config_.battery_low + kBatteryHysteresis, dt);
  empty_.update(volt<config_.battery_empty, volt> config_.battery_empty + kBatteryHysteresis, dt);
}

void BoardWatch::update(const Sensors& image, bool waits, Nanos dt) noexcept {
  if (image.board.absent) return updateWithoutBoard(image, dt);
  const BoardSensors& seen = image.board;
  lost_now_ = start_now_ = false;
  for (Nanos& since : since_) since = std::min(since + dt, kRepowerWindow);
  noteReply(seen.motion);
  if (!online_) {
    powered_ = false;
    power_off_.forget();
  }
  powered_for_ = powered_ ? powered_for_ + dt : Nanos{0};
  if (!answers_now_) return;  // timers count only cycles in which the board replies

  watchPower(seen);
  watchBattery(seen.voltage.value, dt);
  watchTilt(seen, dt);
  const bool pressed = config_.release_button == ReleaseButton::kMode && (seen.buttons & kModeButton) != 0;
  released_.update(pressed, !pressed, dt);
  watchStart((seen.buttons & kStartButton) != 0, waits, dt);
}

/// Servos that reply have power. Whether it was interrupted is known once they were polled.
void BoardWatch::updateWithoutBoard(const Sensors& seen, Nanos dt) noexcept {
  absent_ = true;
  noteReply(seen.bus);
  powered_ = online_;
  powered_for_ = powered_ ? powered_for_ + dt : Nanos{0};
  supply_.update(seen, dt);
  lost_now_ = supply_.interruptedNow();
  if (answers_now_) watchBattery(supply_.voltage(), dt);
}

void BoardWatch::watchPower(const BoardSensors& seen) noexcept {
  power_bit_ = seen.servo_power;
  power_off_.update(!seen.servo_power, seen.servo_power);
  if (seen.servo_power && !power_off_.on()) {  // two replies in a row, as for the loss
    powered_ = had_power_ = true;
    lost_ = false;
  }
  if (power_off_.on()) powered_ = false;
  if (power_off_.on() && had_power_ && !lost_) losePower();
}

void BoardWatch::losePower() noexcept {
  lost_ = lost_now_ = true;
  withheld_ = withheld_ || since_.back() < kRepowerWindow;
  std::shift_right(since_.begin(), since_.end(), 1);
  since_.front() = Nanos{0};
}

void BoardWatch::allowPower() noexcept {
  withheld_ = false;
  since_.fill(kRepowerWindow);
}

void BoardWatch::watchStart(bool pressed, bool waits, Nanos dt) noexcept {
  start_was_up_ = waits && (start_was_up_ || !pressed);
  const bool was_on = start_.on();
  const bool counts = pressed && start_was_up_;
  start_now_ = start_.update(counts, !counts, dt) && !was_on;
}

void BoardWatch::watchTilt(const BoardSensors& seen, Nanos dt) noexcept {
  const double tilt = tiltDegrees(seen);
  fell_.update(tilt > config_.fall_tilt, tilt < config_.fall_tilt - kTiltHysteresis, dt);
}

}  // namespace darwinop::safety
