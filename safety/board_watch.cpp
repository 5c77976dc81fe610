// What the board tells about the robot as a whole.
#include "safety/board_watch.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::safety {
namespace {

using std::chrono::milliseconds;

constexpr double kBatteryHysteresis = 0.3;  // V; walking pulls the supply down by about that much
constexpr double kTiltHysteresis = 15;      // deg
constexpr double kLeastGravity = 3.0;       // m/s2; less is free fall or a blow, where direction means nothing
constexpr std::uint8_t kModeButton = 1;

}  // namespace

double tiltDegrees(const BoardSensors& seen) noexcept {
  const auto& a = seen.accelerometer;
  const double length = std::hypot(a[0].value, a[1].value, a[2].value);
  if (!(length >= kLeastGravity) || !std::isfinite(length)) return kUnknown;
  return std::acos(std::clamp(a[2].value / length, -1.0, 1.0)) / kRadPerDegree;
}

BoardWatch::BoardWatch(const Config& config)
    : battery_low_{config.battery_low},
      battery_empty_{config.battery_empty},
      fall_tilt_{config.fall_tilt},
      button_counts_{config.release_button == ReleaseButton::kMode},
      low_{milliseconds{2000}, milliseconds{2000}},
      empty_{milliseconds{2000}, milliseconds{2000}},
      fell_{milliseconds{500}, milliseconds{500}},
      released_{milliseconds{250}, milliseconds{0}} {}

void BoardWatch::update(const BoardSensors& seen, Nanos dt) noexcept {
  answers_now_ = seen.motion.fresh();
  if (seen.motion.ever())
    missed_ = seen.motion.age;
  else if (missed_ <= kPatience)
    ++missed_;
  online_ = seen.motion.ever() && missed_ <= kPatience;
  if (!online_) {
    powered_ = false;
    power_off_.forget();
  }
  powered_for_ = powered_ ? powered_for_ + dt : Nanos{0};
  if (!answers_now_) return;  // timers count time in which the board was heard, and nothing else

  watchPower(seen);
  const double volt = seen.voltage.value;  // NaN fails every comparison: unknown is no fault
  low_.update(volt<battery_low_, volt> battery_low_ + kBatteryHysteresis, dt);
  empty_.update(volt<battery_empty_, volt> battery_empty_ + kBatteryHysteresis, dt);
  watchTilt(seen, dt);
  const bool pressed = button_counts_ && (seen.buttons & kModeButton) != 0;
  released_.update(pressed, !pressed, dt);
}

void BoardWatch::watchPower(const BoardSensors& seen) noexcept {
  power_bit_ = seen.servo_power;
  power_off_.update(!seen.servo_power, seen.servo_power);
  if (seen.servo_power && !power_off_.on()) powered_ = had_power_ = true;  // as often confirmed as its loss
  if (power_off_.on()) powered_ = false;
}

void BoardWatch::watchTilt(const BoardSensors& seen, Nanos dt) noexcept {
  const double tilt = tiltDegrees(seen);
  fell_.update(tilt > fall_tilt_, tilt < fall_tilt_ - kTiltHysteresis, dt);
}

}  // namespace darwinop::safety
