// Commands of a controller for one cycle. The loop uses the newest image; a default-constructed one requests nothing.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "core/flag.hpp"
#include "core/joints.hpp"
#include "core/units.hpp"

namespace darwinop {

/// Commands for one joint. A field is valid only if its bit in `set` is on; the set functions do this. Values are not
/// checked here: safety does that.
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

/// [Safety] and [Limits] of a controller, for its session. Limits, and settings that protect the robot, can only become
/// stricter; the others, such as `stall_ms`, are the session's: safety/session_settings.hpp.
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
  /// Number of the driving session; 0: none yet. A change means a new session, which safety starts gently.
  std::uint32_t session = 0;
  /// Counts the images of a session (heartbeat): if it stops, the controller has stalled.
  std::uint64_t sequence = 0;
  /// Creation time, ns on the loop's clock.
  std::int64_t made_ns = 0;
  /// True in the last image of a session that ends normally.
  Flag end_of_session{};
  /// True in the last image of a session that leaves the robot holding, at most for gone_s: a takeover or a move to the
  /// start pose that still runs is stopped where it is, and a robot without torque stays so.
  Flag hold{};
  /// Counts requests to clear latched faults; a change is one request. Ignored if `unattended`.
  std::uint32_t fault_resets = 0;
  /// Take over in the present pose, without the slow move to the start pose.
  Flag start_where_it_is{};
  /// A program, not a person, started this session (restart after a crash). It cannot clear latched faults: a robot
  /// that a person released stays limp until a person acts.
  Flag unattended{};
  /// Read in the first image of a session only.
  SessionSettings settings{};
  /// Filled in by the loop: nothing will watch the robot after this session. The robot's own `on_exit` holds then.
  Flag loop_ends{};
  /// Requests of an operator, independent of the controller; filled in by the loop. A change is one request.
  std::uint32_t operator_resets = 0;    // clear latched faults
  std::uint32_t operator_releases = 0;  // torque off on every joint
};
static_assert(std::is_trivially_copyable_v<Commands>);

}  // namespace darwinop
