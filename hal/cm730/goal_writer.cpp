#include "hal/cm730/goal_writer.hpp"

#include <algorithm>

#include "core/conversions.hpp"
#include "core/registers.hpp"

namespace darwinop::cm730 {
namespace {

constexpr std::uint8_t kFullBytes = 8;  // 28 P gain, 29 reserved, 30 goal, 32 speed, 34 torque limit
static_assert(servo::kTorqueLimit + 2 - servo::kPGain == kFullBytes);

}  // namespace

std::uint16_t GoalWriter::goalTicks(Joint joint, Rad goal) noexcept {
  const int wanted = offsets_.servoTicks(joint, goal);
  const int ticks = std::clamp<int>(wanted, row(joint).low, row(joint).high);
  if (ticks != wanted) ++clamped_;
  return static_cast<std::uint16_t>(ticks);
}

std::span<const std::uint8_t> GoalWriter::encode(const SafeCommands& commands) noexcept {
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

bool GoalWriter::settingsChanged(const SafeCommands& commands) noexcept {
  bool changed = false;
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (!commands.driven()[i]) {
      settings_known_.reset(i);
      continue;
    }
    const SafeCommands::JointGoal& goal = commands.goal(static_cast<Joint>(i));
    const Settings now{registerFromPGain(goal.p_gain), registerFromSpeedLimit(goal.speed_limit),
                       registerFromTorque(goal.torque_limit)};
    if (settings_known_[i] && settings_[i] == now) continue;
    settings_[i] = now;
    settings_known_.set(i);
    changed = true;
  }
  return changed;
}

std::span<const std::uint8_t> GoalWriter::encodeGoals(const SafeCommands& commands) noexcept {
  const bool full = settingsChanged(commands) || ++since_full_ >= kFullEvery;
  if (full) since_full_ = 0;
  SyncWriteEncoder sync =
      full ? SyncWriteEncoder{frame_, servo::kPGain, kFullBytes} : SyncWriteEncoder{frame_, servo::kGoalPosition, 2};
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (!commands.driven()[i]) continue;
    const auto joint = static_cast<Joint>(i);
    const std::uint16_t ticks = goalTicks(joint, commands.goal(joint).goal);
    const Settings& s = settings_[i];
    const std::array<std::uint8_t, kFullBytes> data{
        s.p_gain,          0, lowByte(ticks), highByte(ticks), lowByte(s.speed), highByte(s.speed), lowByte(s.torque),
        highByte(s.torque)};
    sync.add(kJointTable[i].id, full ? Bytes{data} : Bytes{data}.subspan(2, 2));
  }
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
