// Turns safe commands into the cycle's SyncWrite, as short as it may be (docs/performance.md has the sizes). Two of
// them only while a servo works at its torque limit and limits change.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "core/packet.hpp"
#include "core/registers.hpp"
#include "core/safe_commands.hpp"
#include "hal/cm730/joint_offsets.hpp"

namespace darwinop::cm730 {

/// A goal write switches torque on by itself, so a servo that has restarted must not get a goal without a speed limit:
/// goals alone are sent only while each servo in the frame is known to have its settings. A joint that is not driven
/// in a cycle is not known any more.
///
/// Writing the torque limit makes a servo forget that it shut itself off, and a goal write switches its torque on
/// again. Limits are written when a joint enters, and else only when they have changed. A servo shuts itself off after
/// it has worked at its torque limit for long: while one does, limits go without goals, after kTorqueEvery cycles at
/// the earliest, and are polled in the same cycle: the torque of a servo that has shut itself off is still off.
class GoalWriter {
 public:
  explicit GoalWriter(const JointOffsets& offsets = {}) : offsets_{offsets} { forget(); }

  /// The frame to send; empty when there is nothing to say. Valid until the next call.
  std::span<const std::uint8_t> encode(const SafeCommands& commands) noexcept;

  /// What a servo has answered: its load, fraction of the greatest torque.
  void noteLoad(Joint joint, double load) noexcept;

  /// Locks the EEPROM of every servo until its power is cut: an 8-bit checksum lets one damaged frame in 256 pass,
  /// and none of those may change an id, a baud rate or an angle limit for good.
  std::span<const std::uint8_t> encodeLock() noexcept;

  /// What goes out behind that frame; empty nearly always.
  std::span<const std::uint8_t> takeSecond() noexcept { return std::exchange(second_, {}); }
  /// The last frame carried torque limits and no goals.
  [[nodiscard]] bool limitsWentAlone() const noexcept { return since_torque_ == 0; }
  /// It went to these servos, which work at their limits.
  [[nodiscard]] const SafeCommands::Mask& limitsAlone() const noexcept { return limits_alone_; }

  /// Forget what the servos know, so that the next write is a full one: after a reconnect or a power cut.
  void forget() noexcept { servo_.fill({}); }

  /// Goals that would have left the joint table's range on the wire, since the start. Safety keeps angles within it,
  /// and link keeps room for the offsets: one that is counted here is a bug, and does no harm.
  [[nodiscard]] std::uint32_t clamped() const noexcept { return clamped_; }

  static constexpr int kTorqueEvery = 8;     // cycles
  static constexpr int kSettingsEvery = 16;  // cycles; nobody acknowledges a SyncWrite, so settings are repeated

 private:
  /// A frame that is lost must not leave a servo without its settings: they go out twice in a row.
  static constexpr int kWrites = 2;
  /// Longer than an overload bit after torque on is taken for an old one: TripWatch::kGrace at a period of 8 ms.
  static constexpr std::uint32_t kSettled = 48;
  /// Servos that can be polled in one cycle in any case: BusConfig::polls().
  static constexpr std::size_t kMostPolls = 4;

  /// Registers that a frame writes: a goal is among them, except in kLimit.
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

  /// What goes with a goal and seldom changes.
  struct Settings {
    RadPerSec speed_limit;
    NewtonMeter torque_limit;
    double p_gain = std::numeric_limits<double>::quiet_NaN();
    bool operator==(const Settings&) const = default;
  };
  static Settings settingsOf(const SafeCommands::JointGoal& goal) noexcept {
    return {goal.speed_limit, goal.torque_limit, goal.p_gain};
  }

  /// Written to a servo since its joint entered.
  struct Servo {
    Settings settings;                                 // what the registers below were made from
    std::uint16_t torque = 0;                          // limit
    std::uint16_t least = 0;                           // of the last two limits sent
    std::array<std::uint8_t, kAll.bytes> registers{};  // those of kAll; the goal is filled in when it is sent
    int settings_due = kWrites;                        // writes of P gain and speed
    int torque_due = kWrites;                          // writes of the torque limit
    std::uint8_t entering = kWrites;                   // writes of all of it
    bool straining = false;                            // works at its torque limit, or nearly
  };

  /// What the servos of a frame need together.
  struct Due {
    std::uint8_t all = 0;
    bool straining = false;
    int settings = 0, torque = 0;
    void add(const Servo& servo) noexcept {
      all = static_cast<std::uint8_t>(all | servo.entering);
      straining |= servo.straining;
      settings |= servo.settings_due;
      torque |= servo.torque_due;
    }
  };

  void noteSettings(Servo& servo, const SafeCommands::JointGoal& goal) noexcept;
  void noteLimitSent(std::size_t joint) noexcept;
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
  std::uint32_t clamped_ = 0;
  Buffer frame_{}, second_frame_{};
  std::span<const std::uint8_t> second_;
  std::array<Servo, kJoints> servo_{};
  SafeCommands::Mask limits_alone_, had_their_turn_;
  std::uint32_t frames_ = 0;
  std::array<std::uint16_t, kJoints> sent_{};             // torque limit
  std::array<std::uint32_t, kJoints> entered_{};          // number of the frame
  int since_settings_ = 0, since_torque_ = kTorqueEvery;  // cycles
  // Varies: a servo that trips again and again must not stay in step with the writes that hide it.
  int torque_wait_ = kTorqueEvery;  // cycles, kTorqueEvery .. 2 * kTorqueEvery - 1
};

}  // namespace darwinop::cm730
