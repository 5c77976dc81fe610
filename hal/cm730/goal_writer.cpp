#include "hal/cm730/goal_writer.hpp"

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"

namespace darwinop::cm730 {

inline std::uint16_t GoalWriter::goalTicks(Joint joint, Rad goal) noexcept {
  const int wanted = offsets_.servoTicks(joint, goal);
  const int ticks = std::clamp<int>(wanted, row(joint).low, row(joint).high);
  if (ticks != wanted) ++clamped_;
  return static_cast<std::uint16_t>(ticks);
}

std::span<const std::uint8_t> GoalWriter::encode(const SafeCommands& commands) noexcept {
  forEachJoint(~commands.driven(), [this](std::size_t i) { servo_[i] = {}; });
  since_torque_ = std::min(since_torque_ + 1, torque_wait_);
  since_settings_ = std::min(since_settings_ + 1, kSettingsEvery);
  switch (commands.write()) {
    case SafeCommands::Write::kNothing:
      return {};
    case SafeCommands::Write::kGoals:
      return encodeGoals(commands);
    case SafeCommands::Write::kTorque:
      return encodeTorque(commands);
  }
  return {};
}

void GoalWriter::noteLoad(Joint joint, double load) noexcept {
  constexpr double kStrain = 0.8;  // of the torque limit
  Servo& servo = servo_[index(joint)];
  servo.straining = std::abs(load) * kTorqueMax >= kStrain * servo.torque;
}

void GoalWriter::noteSettings(Servo& servo, const SafeCommands::JointGoal& goal) noexcept {
  servo.settings = settingsOf(goal);
  const std::uint8_t p_gain = registerFromPGain(goal.p_gain);
  const std::uint16_t speed = registerFromSpeedLimit(goal.speed_limit), torque = registerFromTorque(goal.torque_limit);
  auto& r = servo.registers;
  if (p_gain != r[0] || speed != wordAt(r, 4)) servo.settings_due = kWrites;
  if (torque != servo.torque) servo.torque_due = kWrites;
  servo.torque = torque;
  r = {p_gain, 0, 0, 0, lowByte(speed), highByte(speed), lowByte(torque), highByte(torque)};
}

inline const GoalWriter::Block& GoalWriter::choose(const Due& due) const noexcept {
  if (due.all || (due.torque > 0 && (!due.straining || since_torque_ >= torque_wait_))) return kAll;
  return due.settings > 0 || since_settings_ >= kSettingsEvery ? kSettings : kGoal;
}

void GoalWriter::noteSent(const Block& block, const SafeCommands::Mask& who) noexcept {
  if (block.bytes == kGoal.bytes) return;
  since_settings_ = 0;
  if (block.bytes == kAll.bytes) {
    since_torque_ = 0;
    torque_wait_ = kTorqueEvery + (5 * torque_wait_ + 3) % kTorqueEvery;  // each of kTorqueEvery numbers in turn
  }
  forEachJoint(who, [&](std::size_t i) {
    Servo& servo = servo_[i];
    if (servo.settings_due > 0) --servo.settings_due;
    if (block.bytes != kAll.bytes) return;
    if (servo.torque_due > 0) --servo.torque_due;
    servo.entering = servo.entering && servo.torque_due > 0;
  });
}

std::span<const std::uint8_t> GoalWriter::encodeGoals(const SafeCommands& commands) noexcept {
  const SafeCommands::Mask who = commands.driven() & ~commands.held();
  if (who.none()) return {};
  Due due;
  forEachJoint(who, [&](std::size_t i) {
    const SafeCommands::JointGoal& goal = commands.goal(static_cast<Joint>(i));
    Servo& servo = servo_[i];
    if (servo.settings != settingsOf(goal)) noteSettings(servo, goal);
    due.add(servo);
  });
  const Block& block = choose(due);
  noteSent(block, who);
  if (block.bytes == kGoal.bytes) return encodeBlock<kGoal.address, kGoal.bytes>(commands, who);
  if (block.bytes == kSettings.bytes) return encodeBlock<kSettings.address, kSettings.bytes>(commands, who);
  return encodeBlock<kAll.address, kAll.bytes>(commands, who);
}

/// Compiled for each block: a copy of known size is one or two instructions.
template <std::uint8_t kAddress, std::uint8_t kBytes>
std::span<const std::uint8_t> GoalWriter::encodeBlock(const SafeCommands& commands,
                                                      const SafeCommands::Mask& who) noexcept {
  SyncWriteEncoder sync{frame_, kAddress, kBytes};
  forEachJoint(who, [&](std::size_t i) {
    const auto joint = static_cast<Joint>(i);
    const std::uint16_t ticks = goalTicks(joint, commands.goal(joint).goal);
    auto& registers = servo_[i].registers;
    registers[2] = lowByte(ticks);
    registers[3] = highByte(ticks);
    sync.add(servoId(i), std::span{registers}.template subspan<kAddress - kAll.address, kBytes>());
  });
  return sync.finish();
}

std::span<const std::uint8_t> GoalWriter::encodeTorque(const SafeCommands& commands) noexcept {
  SyncWriteEncoder sync{frame_, servo::kTorqueEnable, 1};
  for (std::size_t i = 0; i < kJoints; ++i) {
    const bool on = commands.torqueOn()[i];
    if (!on && !commands.torqueOff()[i]) continue;
    const std::uint8_t value = on ? 1 : 0;
    sync.add(kJointTable[i].id, Bytes{&value, 1});
  }
  return sync.finish();
}

std::span<const std::uint8_t> GoalWriter::encodeLock() noexcept {
  SyncWriteEncoder sync{frame_, servo::kLock, 1};
  constexpr std::uint8_t kLocked = 1;
  for (const JointRow& joint : kJointTable) sync.add(joint.id, Bytes{&kLocked, 1});
  return sync.finish();
}

}  // namespace darwinop::cm730
