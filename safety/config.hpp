// Settings of the safety layer: default, unit, range and reason of each; section [Safety] of config.ini.
#pragma once

#include <array>
#include <bitset>
#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/conversions.hpp"
#include "core/faults.hpp"
#include "core/joints.hpp"
#include "core/units.hpp"

namespace darwinop::safety {

using Nanos = std::chrono::nanoseconds;

enum class OnFall : std::uint8_t { kReport, kLimp };
enum class OnExit : std::uint8_t { kHold, kKneel, kLimp };
enum class ReleaseButton : std::uint8_t { kMode, kNone };
enum class StartMove : std::uint8_t { kPose, kHold };

// In the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kOnFallNames{"report", "limp"};
inline constexpr std::array<std::string_view, 3> kOnExitNames{"hold", "kneel", "limp"};
inline constexpr double kLeastGentleSpeed = 0.05;  // rad/s; a crouch takes up to three minutes
constexpr Reaction atExit(OnExit asked) {
  if (asked == OnExit::kHold) return Reaction::kHold;
  return asked == OnExit::kLimp ? Reaction::kLimp : Reaction::kKneel;
}
inline constexpr std::array<std::string_view, 2> kReleaseButtonNames{"mode", "none"};
inline constexpr std::array<std::string_view, 2> kStartMoveNames{"pose", "hold"};

/// Allowed goals of a joint, rad.
struct JointRange {
  Rad low, high;
};

/// Mechanical range. A configuration may narrow it, never widen it.
constexpr JointRange hardRange(Joint joint) {
  return {radFromTicks(row(joint).low), radFromTicks(row(joint).high)};
}
constexpr std::array<JointRange, kJoints> hardRanges() {
  std::array<JointRange, kJoints> all{};
  for (std::size_t i = 0; i < kJoints; ++i) all[i] = hardRange(static_cast<Joint>(i));
  return all;
}

/// Error text for a key of [Limits] that is not a joint.
inline constexpr const char* kNoSuchJoint = "no joint has this name; joints are called as in Webots, e.g. Neck";

struct Config {
  /// Period until the loop reports its own.
  Nanos period{std::chrono::milliseconds{16}};

  double max_joint_speed = kMaxVelocity;
  double gentle_speed = kGentleSpeed;
  double default_speed = kFullSpeed;
  double default_torque = kMaxTorqueNm;
  double default_p_gain = kDefaultPGain;
  double silent_s = 0.5;
  double take_over_s = 1.0;
  double start_tolerance = 0.15;
  double stall_ms = 500;
  double gone_s = 10;
  double battery_low = kBatteryLowV;
  double battery_empty = kBatteryEmptyV;
  double hot = kServoHotC;
  double overheat = kServoOverheatC;
  double fall_tilt = 60;
  OnFall on_fall = OnFall::kReport;
  OnExit on_exit = OnExit::kKneel;
  ReleaseButton release_button = ReleaseButton::kMode;
  StartMove start = StartMove::kPose;

  /// Section [Limits]: `Neck = -1.0, 1.0`.
  std::array<JointRange, kJoints> range = hardRanges();

  /// Joints that are never driven. `absent` (robot.ini): also not read, and no fault. `left_out` (at start-up): read
  /// and reported. `no_writes`, a part of `left_out`: no torque off either, because nothing shows that it is an MX-28.
  std::bitset<kJoints> absent, left_out, no_writes;

  /// An earlier loop held joints at its end (runtime/robot_notes.hpp): servo power that is off at the start was lost
  /// under torque.
  bool held_before = false;

  /// Settings of [Safety] that a file sets, in the order of visit(); the others are defaults. safety/layers.hpp
  std::bitset<32> named;

  /// Calls v(name, value, low, high, unit, why) for each number and v(name, value, choices, why) for each choice.
  template <class V>
  void visit(V&& v) {
    visitFields(*this, v);
  }
  template <class V>
  void visit(V&& v) const {
    visitFields(*this, v);
  }

  /// Parses one line of an INI file. Throws std::runtime_error with key and allowed values.
  void set(std::string_view section, std::string_view key, std::string_view value);

  /// Throws std::runtime_error if a setting is out of range or settings contradict each other.
  void check() const;
  /// Error message about settings that contradict each other; null: none do.
  [[nodiscard]] const char* contradiction() const noexcept;

 private:
  template <class Self, class V>
  static void visitFields(Self& c, V& v) {
    v("max_joint_speed", c.max_joint_speed, 0.1, kMaxVelocity, "rad/s",
      "a goal never moves faster; 12.26 is the MX-28");
    v("gentle_speed", c.gentle_speed, kLeastGentleSpeed, 3.0, "rad/s",
      "start, kneel, hot servos, joints that come back");
    v("default_speed", c.default_speed, kLeastSpeed, kFullSpeed, "rad/s", "speed limit of a joint that was given none");
    v("default_torque", c.default_torque, 0.05, kMaxTorqueNm, "N m", "torque limit of a joint that was given none");
    v("default_p_gain", c.default_p_gain, kGainPerCount, kMaxPGain, "", "P gain of a joint that was given none");
    v("silent_s", c.silent_s, 0.1, 5.0, "s", "a servo silent for longer is reported as servo_silent");
    v("take_over_s", c.take_over_s, 0.1, 10.0, "s", "wait for servos to answer before starting without them");
    v("start_tolerance", c.start_tolerance, 0.02, 1.0, "rad", "a joint this close has reached the start pose");
    v("stall_ms", c.stall_ms, 50.0, 10000.0, "ms", "a controller silent for longer is held");
    v("gone_s", c.gone_s, 0.1, 3600.0, "s", "a controller silent for longer is given up");
    v("battery_low", c.battery_low, kServoSupplyLow, kServoSupplyHigh, "V",
      "reported under this; 3 LiPo cells at 3.67 V");
    v("battery_empty", c.battery_empty, kServoSupplyLow, kServoSupplyHigh, "V",
      "kneels under this; LiPo cells are harmed under 3.3 V");
    v("hot", c.hot, 30.0, kServoShutdownC - 1, "deg C", "joints move gently from here on");
    v("overheat", c.overheat, 30.0, kServoShutdownC - 1, "deg C",
      "kneels from here on; servos shut themselves off at 80");
    v("fall_tilt", c.fall_tilt, 20.0, 170.0, "deg", "a trunk tilted by more has fallen");
    v("on_fall", c.on_fall, std::span<const std::string_view>{kOnFallNames}, "limp protects the gears");
    v("on_exit", c.on_exit, std::span<const std::string_view>{kOnExitNames}, "after a normal end of the controller");
    v("release_button", c.release_button, std::span<const std::string_view>{kReleaseButtonNames},
      "held for 0.25 s it switches torque off");
    v("start", c.start, std::span<const std::string_view>{kStartMoveNames},
      "pose: a new controller starts from the start pose; hold: from where the robot is");
  }
};

constexpr Nanos fromSeconds(double s) {
  return Nanos{static_cast<Nanos::rep>(s * 1e9)};
}

}  // namespace darwinop::safety
