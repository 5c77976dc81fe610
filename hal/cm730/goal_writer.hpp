// Turns safe commands into the cycle's one SyncWrite: registers 28..35, or goals alone when only they changed.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/packet.hpp"
#include "core/safe_commands.hpp"
#include "hal/cm730/joint_offsets.hpp"

namespace darwinop::cm730 {

class GoalWriter {
 public:
  explicit GoalWriter(const JointOffsets& offsets = {}) : offsets_{offsets} {}

  /// The frame to send; empty when there is nothing to say. Valid until the next call.
  std::span<const std::uint8_t> encode(const SafeCommands& commands) noexcept;

  /// Locks the EEPROM of every servo until its power is cut: an 8-bit checksum lets one damaged frame in 256 pass,
  /// and none of those may change an id, a baud rate or an angle limit for good.
  std::span<const std::uint8_t> encodeLock() noexcept;

  /// Forget what the servos know, so that the next write is a full one: after a reconnect or a power cut.
  void forget() noexcept { since_full_ = kFullEvery; }

  /// Goals that would have left the joint table's range on the wire, since the start. Safety keeps angles within it,
  /// and link keeps room for the offsets: one that is counted here is a bug, and does no harm.
  [[nodiscard]] std::uint32_t clamped() const noexcept { return clamped_; }

 private:
  static constexpr int kFullEvery = 16;  // cycles; a SyncWrite is not acknowledged, so settings are repeated

  /// Registers 28..35 of a servo without the goal.
  struct Settings {
    std::uint8_t p_gain = 0;
    std::uint16_t speed = 0, torque = 0;
    bool operator==(const Settings&) const = default;
  };

  std::span<const std::uint8_t> encodeGoals(const SafeCommands& commands) noexcept;
  std::span<const std::uint8_t> encodeTorque(const SafeCommands& commands) noexcept;
  bool settingsChanged(const SafeCommands& commands) noexcept;
  std::uint16_t goalTicks(Joint joint, Rad goal) noexcept;

  JointOffsets offsets_;
  std::uint32_t clamped_ = 0;
  std::array<std::uint8_t, kMaxFrame> frame_{};
  std::array<Settings, kJoints> settings_{};
  SafeCommands::Mask settings_known_;
  int since_full_ = kFullEvery;
};

}  // namespace darwinop::cm730
