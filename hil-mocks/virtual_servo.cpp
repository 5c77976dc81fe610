// Registers, power and errors of a virtual MX-28.
#include "hil-mocks/virtual_servo.hpp"

#include <algorithm>
#include <array>
#include <utility>

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
constexpr std::uint8_t kMaxTorque = addressOf("max_torque");
constexpr std::uint8_t kRegistered = addressOf("registered"), kLock = addressOf("lock");

const TableLayout& layoutOfModel(std::uint16_t number) {
  const ServoModel* const model = findServoModel(number);
  return model != nullptr && model->use == ServoUse::kIfPermitted ? kStrongerServoLayout : kServoLayout;
}

double strengthOf(std::uint16_t number) {
  const ServoModel* const model = findServoModel(number);
  return model != nullptr ? model->stall_torque / kMaxTorqueNm : 1;
}

}  // namespace

VirtualServo::VirtualServo(Joint joint, const ServoOptions& options)
    : BusDevice{layoutOfModel(options.model)},
      joint_{joint},
      strength_{strengthOf(options.model)},
      keeps_torque_{options.keeps_torque},
      torque_by_goal_{options.torque_by_goal},
      missing_{options.missing},
      torque_control_{options.torque_control},
      position_{row(joint).start} {
  table_.setByte(servo::kId, options.id == 0 ? row(joint).id : options.id);
  table_.setByte(servo::kFirmware, options.firmware);
  table_.setByte(servo::kReturnDelay, options.return_delay);
  table_.setByte(servo::kStatusLevel, options.status_level);
  table_.setByte(kBaudAddress, options.baud);
  table_.setWord(kModel, options.model);
  table_.setWord(kCwLimit, options.cw_limit);
  table_.setWord(kCcwLimit, options.ccw_limit);
  table_.setWord(kMaxTorque, options.max_torque);
  table_.setByte(servo::kDriveMode, options.drive_mode);
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
  if (std::exchange(torque_control_, false)) table_.setByte(servo::kTorqueControl, 1);
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
  const bool closed = table_.byte(kLock) != 0 || table_.byte(servo::kTorqueEnable) != 0;
  if (closed && table_.touches(Memory::kEeprom, address, data)) return error_bit::kRange;
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
  if (keeps_torque_ && before.torque_enable) table_.setByte(servo::kTorqueEnable, 1);
  // Protocol 1 servos enable torque automatically on a goal write.
  if (torque_by_goal_ && address <= servo::kGoalPosition && address + data.size() > servo::kGoalPosition)
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

}  // namespace darwinop::hil
