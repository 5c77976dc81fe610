// Motor of a virtual MX-28: what its registers require of the body, what the body does to them, and its protections.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/conversions.hpp"
#include "hil-mocks/virtual_servo.hpp"

namespace darwinop::hil {
namespace {

constexpr std::uint8_t kShutdown = find(kMx28, "shutdown").address, kMoving = find(kMx28, "moving").address;
constexpr std::uint8_t kDGain = find(kMx28, "d_gain").address, kIGain = find(kMx28, "i_gain").address;
constexpr std::uint8_t kPresentSpeed = find(kMx28, "present_speed").address;
constexpr std::uint8_t kPresentLoad = find(kMx28, "present_load").address;
constexpr std::uint8_t kGoalAcceleration = find(kMx28, "goal_acceleration").address;
constexpr double kAheadRad = 1;  // lead of the goal of a turning wheel
constexpr int kMovingTicks = 4;  // a larger distance to the goal counts as moving

}  // namespace

std::uint8_t VirtualServo::rounded(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::nearbyint(value), 0.0, 255.0));
}

void VirtualServo::setJam(std::optional<Nanos> trips_after) {
  trips_after_ = trips_after;
  if (!trips_after) strained_for_ = Nanos{0};
}

void VirtualServo::strain(Nanos dt) {
  if (!trips_after_) return;
  strained_for_ = state().pulls() ? strained_for_ + dt : Nanos{0};
  if (strained_for_ >= *trips_after_) strain_trips_ = true;
}

/// Wraps at one turn in wheel mode; signed multi-turn ticks in multi-turn mode.
std::uint16_t VirtualServo::positionRegister(double position_rad) const {
  if (!wheelMode() && !multiTurnMode()) return static_cast<std::uint16_t>(ticksFromRad(Rad{position_rad}));
  const long ticks = std::lround(position_rad / kRadPerTick) + kTickCentre;
  return static_cast<std::uint16_t>(wheelMode() ? ticks & kTickMax : ticks);
}

/// Inputs of the protections, updated continuously.
void VirtualServo::feel(const JointMotion& motion) {
  const double celsius = std::isnan(motion.temperature_c) ? usual_temperature_c_ : motion.temperature_c;
  const double volt = std::isnan(motion.supply_v) ? supply_v_ : motion.supply_v;
  table_.setByte(servo::kPresentTemperature, rounded(forced_temperature_c_.value_or(celsius)));
  table_.setByte(servo::kPresentVoltage, rounded(volt * 10));
  // Without torque the body has no load: the bit stays until the torque limit is written.
  overloaded_ = motion.overload || strain_trips_ || (overloaded_ && table_.word(servo::kTorqueLimit) == 0);
}

void VirtualServo::measure(const JointMotion& motion) {
  feel(motion);
  position_ = positionRegister(motion.position_rad);
  if (!powered_) return;
  table_.setWord(servo::kPresentPosition, position_);
  table_.setWord(kPresentSpeed, registerFromVelocity(RadPerSec{motion.velocity_rad_s}));
  const bool stuck = trips_after_ && state().pulls();  // at its torque limit
  const double limit = table_.word(servo::kTorqueLimit) / static_cast<double>(kTorqueMax);
  table_.setWord(kPresentLoad, registerFromLoad(stuck ? std::copysign(limit, motion.load) : motion.load / strength_));
  const int away = std::abs(int{table_.word(servo::kGoalPosition)} - int{position_});
  table_.setByte(kMoving, table_.byte(servo::kTorqueEnable) != 0 && away > kMovingTicks ? 1 : 0);
}

void VirtualServo::updateDrive() {
  const std::uint16_t speed = table_.word(servo::kMovingSpeed);
  drive_.torque_on = table_.byte(servo::kTorqueEnable) != 0;
  drive_.goal_rad = radFromTicks(table_.word(servo::kGoalPosition)).value;
  drive_.endless = wheelMode() || multiTurnMode();
  drive_.speed_limit_rad_s = speed == 0 ? std::numeric_limits<double>::infinity() : speed * kRadPerSecPerCount;
  if (wheelMode()) drive_.speed_limit_rad_s = (speed & ~kClockwise) * kRadPerSecPerCount;  // 0 stops it
  const std::uint8_t acceleration = table_.byte(kGoalAcceleration);
  drive_.accel_limit_rad_s2 = acceleration == 0 ? std::numeric_limits<double>::infinity()
                                                : acceleration * find(kMx28, "goal_acceleration").scale;
  drive_.torque_limit = std::min(1.0, strength_ * table_.word(servo::kTorqueLimit) / kTorqueMax);
  drive_.p_gain = strength_ * table_.byte(servo::kPGain) * find(kMx28, "p_gain").scale;
  drive_.i_gain = strength_ * table_.byte(kIGain) * find(kMx28, "i_gain").scale;
  drive_.d_gain = strength_ * table_.byte(kDGain) * find(kMx28, "d_gain").scale;
}

const ServoDrive& VirtualServo::drive(const JointMotion& motion) {
  feel(motion);
  drive_.supply_v = supply_v_;
  if (!powered_) {
    drive_.torque_on = false;
    return drive_;
  }
  const std::uint8_t tripped = standingErrors() & table_.byte(kShutdown);
  if (tripped != 0) {
    const ServoState before = state();
    table_.setWord(servo::kTorqueLimit, 0);
    table_.setByte(servo::kTorqueEnable, 0);
    strain_trips_ = false;
    updateDrive();
    if (observer_ != nullptr && before.pulls()) observer_->changed(joint_, ServoEvent::kTripped, before, state());
  }
  drive_.torque_on = table_.byte(servo::kTorqueEnable) != 0;
  if (wheelMode()) {  // turns continuously, independent of the goal register
    const bool clockwise = (table_.word(servo::kMovingSpeed) & kClockwise) != 0;
    drive_.goal_rad = motion.position_rad + (clockwise ? -kAheadRad : kAheadRad);
  }
  return drive_;
}

}  // namespace darwinop::hil
