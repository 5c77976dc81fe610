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
  ++frames_;
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

inline double GoalWriter::strainAt(std::size_t joint, std::uint16_t limit) const noexcept {
  constexpr double kStrain = 0.8;  // of the torque limit
  return kStrain * stall_.load(static_cast<Joint>(joint), limit);
}

void GoalWriter::repeatLimit(Joint joint, NewtonMeter found) noexcept {
  Servo& servo = servo_[index(joint)];
  const bool has_shut_off = stall_.limitRegister(joint, found) == 0;
  if (servo.entering > 0 || servo.torque_due > 0 || servo.repeats == 0 || has_shut_off) return;
  --servo.repeats;
  servo.torque_due = kWrites;
}

void GoalWriter::noteSettings(Joint joint, const SafeCommands::JointGoal& goal) noexcept {
  Servo& servo = servo_[index(joint)];
  servo.settings = settingsOf(goal);
  const std::uint8_t p_gain = registerFromPGain(goal.p_gain);
  const std::uint16_t speed = registerFromSpeedLimit(goal.speed_limit);
  const std::uint16_t torque = stall_.limitRegister(joint, goal.torque_limit);
  auto& r = servo.registers;
  if (p_gain != r[0] || speed != wordAt(r, 4)) servo.settings_due = kWrites;
  if (torque != servo.torque) {
    servo.torque_due = kWrites;
    servo.repeats = kRepeats;
  }
  servo.torque = torque;
  limit_[index(joint)] = stall_.limit(joint, torque).value;
  r = {p_gain, 0, 0, 0, lowByte(speed), highByte(speed), lowByte(torque), highByte(torque)};
}

inline const GoalWriter::Block& GoalWriter::choose(const Due& due) const noexcept {
  if (due.all > 0 || due.torque > 0) return kAll;
  return due.settings > 0 || since_settings_ >= kSettingsEvery ? kSettings : kGoal;
}

void GoalWriter::noteSent(const Block& block, const SafeCommands::Mask& who) noexcept {
  if (block.bytes == kGoal.bytes) return;
  since_settings_ = 0;
  forEachJoint(who, [&](std::size_t i) {
    Servo& servo = servo_[i];
    if (servo.settings_due > 0) --servo.settings_due;
    if (block.bytes != kAll.bytes) return;
    noteLimitSent(i);
    if (servo.entering == 0) return;
    entered_[i] = frames_;
    --servo.entering;
  });
}

/// The servo now has this limit or, if the frame is lost, the previous one.
void GoalWriter::noteLimitSent(std::size_t joint) noexcept {
  Servo& servo = servo_[joint];
  if (servo.torque_due > 0) --servo.torque_due;
  servo.strain = strainAt(joint, servo.entering > 0 ? servo.torque : std::min(servo.torque, sent_[joint]));
  sent_[joint] = servo.torque;
}

std::span<const std::uint8_t> GoalWriter::encodeGoals(const SafeCommands& commands) noexcept {
  const SafeCommands::Mask who = commands.driven() & ~commands.skipped();
  if (who.none()) return {};
  Due due;
  forEachJoint(who, [&](std::size_t i) {
    const auto joint = static_cast<Joint>(i);
    const SafeCommands::JointGoal& goal = commands.goal(joint);
    Servo& servo = servo_[i];
    if (servo.settings != settingsOf(goal)) noteSettings(joint, goal);
    due.add(servo);
  });
  if (due.straining && (due.all > 0 || due.torque > 0)) return encodeTwo(commands, who);
  const Block& block = choose(due);
  noteSent(block, who);
  if (block.bytes == kGoal.bytes) return encodeBlock<kGoal.address, kGoal.bytes>(frame_, commands, who);
  if (block.bytes == kSettings.bytes) return encodeBlock<kSettings.address, kSettings.bytes>(frame_, commands, who);
  return encodeBlock<kAll.address, kAll.bytes>(frame_, commands, who);
}

/// Two frames: a servo that works at its torque limit must not get a limit together with a goal.
std::span<const std::uint8_t> GoalWriter::encodeTwo(const SafeCommands& commands,
                                                    const SafeCommands::Mask& who) noexcept {
  Due due;
  forEachJoint(who, [&](std::size_t i) { due.add(servo_[i]); });
  std::span<const std::uint8_t> frame;
  SafeCommands::Mask rest = who;
  if (due.all > 0) {
    const auto first =
        jointsThat(who, [this](std::size_t i) { return servo_[i].entering > 0 || !servo_[i].straining; });
    noteSent(kAll, first);
    frame = encodeBlock<kAll.address, kAll.bytes>(frame_, commands, first);
    rest &= ~first;
  } else if (since_torque_ >= torque_wait_) {
    frame = encodeLimits(who);
    if (!frame.empty()) rest &= ~limits_alone_;
  }
  if (rest.none()) return frame;
  const bool settings = due.settings > 0 || since_settings_ >= kSettingsEvery;
  noteSent(settings ? kSettings : kGoal, rest);
  second_ = settings ? encodeBlock<kSettings.address, kSettings.bytes>(second_frame_, commands, rest)
                     : encodeBlock<kGoal.address, kGoal.bytes>(second_frame_, commands, rest);
  return frame.empty() ? takeSecond() : frame;
}

/// New torque limits only: goals of limitsAlone() are delayed by a cycle. Empty if no servo may get a limit yet.
std::span<const std::uint8_t> GoalWriter::encodeLimits(const SafeCommands::Mask& who) noexcept {
  const auto due =
      jointsThat(who, [this](std::size_t i) { return servo_[i].torque_due > 0 && frames_ - entered_[i] >= kSettled; });
  const auto straining = jointsThat(due, [this](std::size_t i) { return servo_[i].straining; });
  if ((straining & ~had_their_turn_).none()) had_their_turn_.reset();
  limits_alone_.reset();
  forEachJoint(straining & ~had_their_turn_, [this](std::size_t i) {
    if (limits_alone_.count() < kMostPolls) limits_alone_.set(i);
  });
  had_their_turn_ |= limits_alone_;
  SyncWriteEncoder sync{frame_, kLimit.address, kLimit.bytes};
  forEachJoint((due & ~straining) | limits_alone_, [&](std::size_t i) {
    noteLimitSent(i);
    sync.add(servoId(i), std::span{servo_[i].registers}.subspan(kLimit.address - kAll.address, kLimit.bytes));
  });
  const auto frame = sync.finish();
  if (!frame.empty()) {
    since_torque_ = 0;
    torque_wait_ = kTorqueEvery + (5 * torque_wait_ + 3) % kTorqueEvery;  // visits all kTorqueEvery values
  }
  return frame;
}

/// Compiled for each block: a copy of known size is one or two instructions.
template <std::uint8_t kAddress, std::uint8_t kBytes>
std::span<const std::uint8_t> GoalWriter::encodeBlock(Buffer& out, const SafeCommands& commands,
                                                      const SafeCommands::Mask& who) noexcept {
  SyncWriteEncoder sync{out, kAddress, kBytes};
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

std::span<const std::uint8_t> GoalWriter::encodeLock(const SafeCommands::Mask& who) noexcept {
  SyncWriteEncoder sync{frame_, servo::kLock, 1};
  constexpr std::uint8_t kLocked = 1;
  forEachJoint(who, [&](std::size_t i) { sync.add(servoId(i), Bytes{&kLocked, 1}); });
  return sync.finish();
}

}  // namespace darwinop::cm730
