// Encodes safe commands as the cycle's SyncWrite, as short as possible (sizes: docs/performance.md). Two frames only
// while a servo works at its torque limit and limits change.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "core/packet.hpp"
#include "core/registers.hpp"
#include "core/safe_commands.hpp"
#include "hal/cm730/joint_offsets.hpp"
#include "hal/cm730/stall_torques.hpp"

namespace darwinop::cm730 {

/// A goal write switches torque on, so a restarted servo must not get a goal without a speed limit: frames with goals
/// only are sent while each servo in the frame is known to have its settings. If a joint is not driven in a cycle, its
/// settings count as unknown again.
///
/// Writing the torque limit clears a servo's automatic shutdown, and a goal write then switches its torque on again. So
/// limits are written when a joint is taken over, and later only when they change or a poll finds that one was lost. A
/// servo shuts itself off after working at its torque limit for some time: while one does, limits are sent without
/// goals, at most every kTorqueEvery cycles, and polled in the same cycle, in which the torque of a servo that has shut
/// itself off is still off.
class GoalWriter {
 public:
  explicit GoalWriter(const JointOffsets& offsets = {}, const StallTorques& stall = {})
      : offsets_{offsets}, stall_{stall} {
    forget();
  }

  /// The frame to send; empty if there is nothing to send. Valid until the next call.
  std::span<const std::uint8_t> encode(const SafeCommands& commands) noexcept;

  /// Load that a servo reported, as a fraction of an MX-28's maximum torque.
  void noteLoad(Joint joint, double load) noexcept {
    Servo& servo = servo_[index(joint)];
    servo.straining = std::abs(load) >= servo.strain;
  }
  /// Torque limit that a poll found in a servo after the cycle's write. One that differs from the limit sent was lost,
  /// and is sent again. 0: the servo has shut itself off, which a limit would undo.
  void noteLimit(Joint joint, NewtonMeter found) noexcept {
    constexpr double kRounding = 1e-6;  // N m; a count is 2.4e-3 and more
    if (std::abs(found.value - limit_[index(joint)]) > kRounding) return repeatLimit(joint, found);
    servo_[index(joint)].repeats = kRepeats;
  }

  /// Locks the EEPROM of those servos until power-off: with an 8-bit checksum one damaged frame in 256 is accepted, and
  /// it must not change an id, a baud rate or an angle limit permanently.
  std::span<const std::uint8_t> encodeLock(const SafeCommands::Mask& who) noexcept;

  /// Frame to send after the first one; nearly always empty.
  std::span<const std::uint8_t> takeSecond() noexcept { return std::exchange(second_, {}); }
  /// The last frame carried torque limits and no goals.
  [[nodiscard]] bool limitsWentAlone() const noexcept { return since_torque_ == 0; }
  /// The servos of that frame, which work at their limits.
  [[nodiscard]] const SafeCommands::Mask& limitsAlone() const noexcept { return limits_alone_; }

  /// Marks all servos' settings as unknown, so that the next write is complete: after a reconnect or a power cut.
  void forget() noexcept { servo_.fill({}); }

  /// Goals clamped to the joint table's range in servo ticks, since the start. Safety and connect() keep goals and
  /// offsets within it, so a count above 0 indicates a bug, without harm.
  [[nodiscard]] std::uint32_t clamped() const noexcept { return clamped_; }

  static constexpr int kTorqueEvery = 8;     // cycles
  static constexpr int kSettingsEvery = 16;  // cycles; a SyncWrite is not acknowledged, so settings are repeated

 private:
  /// Settings are sent twice in a row: a lost frame must not leave a servo without them.
  static constexpr int kWrites = 2;
  /// Times that a lost limit is sent again: one that a servo does not store must not be written for ever, as each write
  /// would undo a shutdown.
  static constexpr std::uint8_t kRepeats = 3;
  /// Cycles; longer than an overload bit is ignored after torque on: TripWatch::kGrace at a period of 8 ms.
  static constexpr std::uint32_t kSettled = 48;
  /// Servos that can always be polled in one cycle: minimum of BusConfig::polls().
  static constexpr std::size_t kMostPolls = 4;

  /// Registers that a frame writes; all but kLimit include the goal.
  struct Block {
    std::uint8_t address, bytes;
  };
  using Buffer = std::array<std::uint8_t, kMaxFrame>;
  static constexpr Block kGoal{servo::kGoalPosition, 2};
  static constexpr Block kSettings{servo::kPGain, 6};  // 28 P gain, 29 reserved, 30 goal, 32 speed
  static constexpr Block kAll{servo::kPGain, 8};       // and 34 torque limit
  static constexpr Block kLimit{servo::kTorqueLimit, 2};
  static_assert(servo::kGoalPosition == servo::kPGain + 2 && servo::kMovingSpeed == servo::kPGain + 4 &&
                servo::kTorqueLimit == servo::kPGain + 6);

  /// Settings sent along with goals; they rarely change.
  struct Settings {
    RadPerSec speed_limit;
    NewtonMeter torque_limit;
    double p_gain = std::numeric_limits<double>::quiet_NaN();
    bool operator==(const Settings&) const = default;
  };
  static Settings settingsOf(const SafeCommands::JointGoal& goal) noexcept {
    return {goal.speed_limit, goal.torque_limit, goal.p_gain};
  }

  /// Values written to a servo since its joint was taken over.
  struct Servo {
    Settings settings;                                 // source of the registers below
    double strain = 0;                                 // load close to the smaller of the last two limits
    std::array<std::uint8_t, kAll.bytes> registers{};  // registers of kAll; the goal is filled in at encoding
    std::uint16_t torque = 0;                          // limit
    std::uint8_t settings_due = kWrites;               // remaining writes of P gain and speed
    std::uint8_t torque_due = kWrites;                 // remaining writes of the torque limit
    std::uint8_t entering = kWrites;                   // remaining complete writes
    std::uint8_t repeats = kRepeats;                   // of this limit, until a poll finds it
    bool straining = false;                            // works close to its torque limit
  };

  /// Union of what the servos of a frame need.
  struct Due {
    std::uint8_t all = 0, settings = 0, torque = 0;
    bool straining = false;
    void add(const Servo& servo) noexcept {
      all = static_cast<std::uint8_t>(all | servo.entering);
      settings = static_cast<std::uint8_t>(settings | servo.settings_due);
      torque = static_cast<std::uint8_t>(torque | servo.torque_due);
      straining |= servo.straining;
    }
  };

  void noteSettings(Joint joint, const SafeCommands::JointGoal& goal) noexcept;
  void noteLimitSent(std::size_t joint) noexcept;
  [[gnu::cold, gnu::noinline]] void repeatLimit(Joint joint, NewtonMeter found) noexcept;
  [[nodiscard]] double strainAt(std::size_t joint, std::uint16_t limit) const noexcept;
  void noteSent(const Block& block, const SafeCommands::Mask& who) noexcept;
  [[nodiscard]] const Block& choose(const Due& due) const noexcept;
  std::span<const std::uint8_t> encodeGoals(const SafeCommands& commands) noexcept;
  template <std::uint8_t kAddress, std::uint8_t kBytes>
  std::span<const std::uint8_t> encodeBlock(Buffer& out, const SafeCommands& commands,
                                            const SafeCommands::Mask& who) noexcept;
  [[gnu::cold, gnu::noinline]] std::span<const std::uint8_t> encodeTwo(const SafeCommands& commands,
                                                                       const SafeCommands::Mask& who) noexcept;
  [[gnu::cold, gnu::noinline]] std::span<const std::uint8_t> encodeLimits(const SafeCommands::Mask& who) noexcept;
  std::span<const std::uint8_t> encodeTorque(const SafeCommands& commands) noexcept;
  std::uint16_t goalTicks(Joint joint, Rad goal) noexcept;

  JointOffsets offsets_;
  StallTorques stall_;
  std::uint32_t clamped_ = 0;
  Buffer frame_{}, second_frame_{};
  std::span<const std::uint8_t> second_;
  std::array<Servo, kJoints> servo_{};
  SafeCommands::Mask limits_alone_, had_their_turn_;
  std::uint32_t frames_ = 0;
  std::array<std::uint16_t, kJoints> sent_{};             // torque limit
  std::array<double, kJoints> limit_{};                   // the newest one as it is read, N m
  std::array<std::uint32_t, kJoints> entered_{};          // number of the frame
  int since_settings_ = 0, since_torque_ = kTorqueEvery;  // cycles
  // Varied, so that a servo that trips periodically does not synchronise with the writes that hide it.
  int torque_wait_ = kTorqueEvery;  // cycles, kTorqueEvery .. 2 * kTorqueEvery - 1
};

}  // namespace darwinop::cm730
