// Requests of a controller for one cycle. The newest image counts; a default-built one requests nothing.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "core/flag.hpp"
#include "core/joints.hpp"
#include "core/units.hpp"

namespace darwinop {

/// Requests for one joint. A field counts only if its bit in `set` is on; the functions set it.
/// Values are as the controller gave them; only safety checks them.
struct JointCommand {
  enum Bit : std::uint8_t { kGoal = 1, kSpeedLimit = 2, kTorqueLimit = 4, kPGain = 8, kTorque = 16 };

  std::uint8_t set = 0;
  Flag torque_on{};          // false: the joint is limp
  Rad goal;                  // rad, limits of the joint table
  RadPerSec speed_limit;     // rad/s, sign ignored; 0 is the slowest, never "no limit"
  NewtonMeter torque_limit;  // N m, 0..2.5
  double p_gain = 0;         // Kp = register 28 / 8, 0..31.75

  [[nodiscard]] constexpr bool has(Bit bit) const { return (set & bit) != 0; }
  constexpr void setGoal(Rad v) {
    goal = v;
    set |= kGoal;
  }
  constexpr void setSpeedLimit(RadPerSec v) {
    speed_limit = v;
    set |= kSpeedLimit;
  }
  constexpr void setTorqueLimit(NewtonMeter v) {
    torque_limit = v;
    set |= kTorqueLimit;
  }
  constexpr void setPGain(double v) {
    p_gain = v;
    set |= kPGain;
  }
  constexpr void setTorque(bool on) {
    torque_on = on;
    set |= kTorque;
  }
};

/// Colours of the board. RGB15: bits 0-4 red, 5-9 green, 10-14 blue. Panel: 1 red, 2 blue, 4 green.
struct LedCommand {
  enum Bit : std::uint8_t { kPanel = 1, kHead = 2, kEye = 4 };

  std::uint8_t set = 0;
  std::uint8_t panel = 0;           // 0..7
  std::uint16_t head = 0, eye = 0;  // 0..0x7FFF

  constexpr bool operator==(const LedCommand&) const = default;
  [[nodiscard]] constexpr bool has(Bit bit) const { return (set & bit) != 0; }
  constexpr void setPanel(std::uint8_t v) {
    panel = v;
    set |= kPanel;
  }
  constexpr void setHead(std::uint16_t v) {
    head = v;
    set |= kHead;
  }
  constexpr void setEye(std::uint16_t v) {
    eye = v;
    set |= kEye;
  }
};

/// [Safety] and [Limits] of the controller that drives, for its session. They make the robot's own stricter, never
/// laxer; safety/session_settings.hpp says how.
struct SessionSettings {
  /// Settings of [Safety] in the order of safety::Config::visit(), choices as their index; then low and high of each
  /// joint in rad.
  static constexpr std::size_t kNumbers = 19, kValues = kNumbers + 2 * kJoints;
  std::array<double, kValues> numbers{};
  std::uint8_t given = 0;  // 0: none, the robot's own settings hold
};

struct Commands {
  std::array<JointCommand, kJoints> joint{};
  LedCommand led{};
  /// Who drives. 0: nobody has yet. A new driver gets a new number, so that safety starts it gently.
  std::uint32_t session = 0;
  /// Counts the images of a session; a number that stops moving is a controller that stalled.
  std::uint64_t sequence = 0;
  /// When the image was made, ns on the clock of the loop.
  std::int64_t made_ns = 0;
  /// True in the last image of a controller that ends normally.
  Flag end_of_session{};
  /// Counts requests to clear latched faults; a change is one request. Ignored while `unattended`.
  std::uint32_t fault_resets = 0;
  /// Skip the slow move to the start pose that a new session begins with, and take over where the robot is.
  Flag start_where_it_is{};
  /// True when a program started this session and no person did (a restart after a crash). Such a session clears no
  /// latched fault: a robot that a person released stays limp until a person acts.
  Flag unattended{};
  /// Read once, in the first image of a session.
  SessionSettings settings{};
  /// Requests of a person, independent of the controller; the loop fills them in. A change is one request.
  std::uint32_t operator_resets = 0;    // clear latched faults
  std::uint32_t operator_releases = 0;  // torque off on every joint
};
static_assert(std::is_trivially_copyable_v<Commands>);

}  // namespace darwinop
