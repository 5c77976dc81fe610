// Registers, power and protections of a virtual MX-28.
#include "hil-mocks/virtual_servo.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/conversions.hpp"

namespace darwinop::hil {
namespace {

constexpr std::uint8_t addressOf(std::string_view name) {
  return find(kMx28, name).address;
}
constexpr std::uint8_t kModel = addressOf("model");
constexpr std::uint8_t kCwLimit = addressOf("cw_limit"), kCcwLimit = addressOf("ccw_limit");
constexpr std::uint8_t kTemperatureLimit = addressOf("temperature_limit");
constexpr std::uint8_t kLowVoltage = addressOf("low_voltage_limit"), kHighVoltage = addressOf("high_voltage_limit");
constexpr std::uint8_t kMaxTorque = addressOf("max_torque"), kShutdown = addressOf("shutdown");
constexpr std::uint8_t kDGain = addressOf("d_gain"), kIGain = addressOf("i_gain");
constexpr std::uint8_t kPresentSpeed = addressOf("present_speed"), kPresentLoad = addressOf("present_load");
constexpr std::uint8_t kGoalAcceleration = addressOf("goal_acceleration");
constexpr std::uint8_t kRegistered = addressOf("registered"), kMoving = addressOf("moving"), kLock = addressOf("lock");
constexpr std::uint16_t kClockwise = 1024;  // bit 10 of the speed register, in wheel mode only
constexpr double kAheadRad = 1;             // lead of the goal of a turning wheel
constexpr int kMovingTicks = 4;             // a larger distance to the goal counts as moving

}  // namespace

VirtualServo::VirtualServo(Joint joint, const ServoOptions& options)
    : BusDevice{kServoLayout}, joint_{joint}, missing_{options.missing}, position_{row(joint).start} {
  table_.setByte(servo::kId, options.id == 0 ? row(joint).id : options.id);
  table_.setByte(servo::kFirmware, options.firmware);
  table_.setByte(servo::kReturnDelay, options.return_delay);
  table_.setByte(servo::kStatusLevel, options.status_level);
  table_.setByte(kBaudAddress, options.baud);
  table_.setWord(kModel, options.model);
  table_.setWord(kCwLimit, options.cw_limit);
  table_.setWord(kCcwLimit, options.ccw_limit);
  table_.setWord(kMaxTorque, options.max_torque);
}

std::uint8_t VirtualServo::rounded(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::nearbyint(value), 0.0, 255.0));
}

ServoState VirtualServo::state() const {
  return {powered_, table_.byte(servo::kTorqueEnable) != 0, table_.word(servo::kTorqueLimit),
          table_.word(servo::kGoalPosition), table_.word(servo::kMovingSpeed)};
}

void VirtualServo::powerDown() {
  if (!powered_) return;
  const ServoState before = state();
  powered_ = false;
  if (observer_ != nullptr) observer_->changed(joint_, ServoEvent::kPowerOff, before, state());
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

void VirtualServo::powerUp(Nanos now, Nanos boot) {
  if (powered_ || missing_ || dead_) return;
  const ServoState before = state();
  powered_ = true;
  awake_at_ = now + boot;
  goal_refused_ = overloaded_ = false;
  forgetRegistered();
  const std::uint8_t temperature = table_.byte(servo::kPresentTemperature), volt = table_.byte(servo::kPresentVoltage);
  table_.reset(Memory::kRam);
  table_.setByte(servo::kPresentTemperature, temperature);
  table_.setByte(servo::kPresentVoltage, volt);
  table_.setWord(servo::kGoalPosition, position_);
  table_.setWord(servo::kPresentPosition, position_);
  table_.setWord(servo::kTorqueLimit, table_.word(kMaxTorque));
  strain_trips_ = false;
  updateDrive();
  if (observer_ != nullptr) observer_->changed(joint_, ServoEvent::kPowerOn, before, state());
}

std::uint8_t VirtualServo::standingErrors() const {
  std::uint8_t bits = injected_errors_;
  const std::uint8_t volt = table_.byte(servo::kPresentVoltage);
  if (volt < table_.byte(kLowVoltage) || volt > table_.byte(kHighVoltage)) bits |= error_bit::kVoltage;
  if (table_.byte(servo::kPresentTemperature) > table_.byte(kTemperatureLimit)) bits |= error_bit::kOverheat;
  if (goal_refused_) bits |= error_bit::kAngleLimit;
  if (overloaded_) bits |= error_bit::kOverload;
  return bits;
}

bool VirtualServo::wheelMode() const {
  return table_.word(kCwLimit) == 0 && table_.word(kCcwLimit) == 0;
}

bool VirtualServo::multiTurnMode() const {
  return table_.word(kCwLimit) == kTickMax && table_.word(kCcwLimit) == kTickMax;
}

bool VirtualServo::goalWithinLimits(std::uint16_t goal) const {
  return wheelMode() || multiTurnMode() || (goal >= table_.word(kCwLimit) && goal <= table_.word(kCcwLimit));
}

/// Wraps at one turn in wheel mode; signed multi-turn ticks in multi-turn mode.
std::uint16_t VirtualServo::positionRegister(double position_rad) const {
  if (!wheelMode() && !multiTurnMode()) return static_cast<std::uint16_t>(ticksFromRad(Rad{position_rad}));
  const long ticks = std::lround(position_rad / kRadPerTick) + kTickCentre;
  return static_cast<std::uint16_t>(wheelMode() ? ticks & kTickMax : ticks);
}

std::uint8_t VirtualServo::objections(std::uint8_t address, Bytes data) const {
  // In wheel mode the speed register includes a direction.
  std::array<std::uint8_t, kMaxFrame> copy{};
  const std::size_t high_byte = servo::kMovingSpeed + 1u - address;
  if (wheelMode() && address <= servo::kMovingSpeed && high_byte < data.size()) {
    std::ranges::copy(data, copy.begin());
    copy[high_byte] &= static_cast<std::uint8_t>(~highByte(kClockwise));
    if (!table_.accepts(address, Bytes{copy}.first(data.size()))) return error_bit::kRange;
  } else if (!table_.accepts(address, data)) {
    return error_bit::kRange;
  }
  if (table_.byte(kLock) != 0 && table_.touches(Memory::kEeprom, address, data)) return error_bit::kRange;
  const bool has_goal = address <= servo::kGoalPosition && address + data.size() > servo::kGoalPosition;
  if (has_goal && !goalWithinLimits(wordAt(data, servo::kGoalPosition - std::size_t{address})))
    return error_bit::kAngleLimit;
  return 0;
}

void VirtualServo::noteRefusal(std::uint8_t errors) {
  goal_refused_ = (errors & error_bit::kAngleLimit) != 0;
}

void VirtualServo::write(std::uint8_t address, Bytes data) {
  const ServoState before = state();
  const bool was_locked = table_.byte(kLock) != 0;
  table_.write(address, data);
  if (was_locked) table_.setByte(kLock, 1);  // only a power cycle unlocks
  // Protocol 1 servos enable torque automatically on a goal write.
  if (address <= servo::kGoalPosition && address + data.size() > servo::kGoalPosition)
    table_.setByte(servo::kTorqueEnable, 1);
  updateDrive();
  if (observer_ != nullptr) observer_->written(joint_, address, data, before, state());
}

void VirtualServo::factoryReset() {
  table_.reset(Memory::kEeprom);
  updateDrive();
}

void VirtualServo::showRegistered(bool waiting) {
  table_.setByte(kRegistered, waiting ? 1 : 0);
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
  table_.setWord(kPresentLoad, registerFromLoad(stuck ? std::copysign(limit, motion.load) : motion.load));
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
  drive_.torque_limit = table_.word(servo::kTorqueLimit) / static_cast<double>(kTorqueMax);
  drive_.p_gain = table_.byte(servo::kPGain) * find(kMx28, "p_gain").scale;
  drive_.i_gain = table_.byte(kIGain) * find(kMx28, "i_gain").scale;
  drive_.d_gain = table_.byte(kDGain) * find(kMx28, "d_gain").scale;
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
