// Columns of a recording: name, unit, meaning and source of the value. A test compares them with docs/logs.md.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/joints.hpp"
#include "runtime/log_row.hpp"

namespace darwinop::runtime {

/// `get` returns NaN for an unknown value: the field is then empty.
struct LogColumn {
  std::string_view name, unit, meaning;  // unit "": dimensionless, printed without brackets
  double (*get)(const LogRow& row);
};

/// One per joint, named "<joint>.<name>".
struct JointLogColumn {
  std::string_view name, unit, meaning;
  double (*get)(const JointCommand& asked, const JointSensors& seen);
};

namespace detail {
constexpr double ms(std::int64_t ns) {
  return static_cast<double>(ns) * 1e-6;
}
constexpr double us(std::int64_t ns) {
  return static_cast<double>(ns) * 1e-3;
}
constexpr double when(bool known, double value) {
  return known ? value : kUnknown;
}
using Asked = JointCommand;
}  // namespace detail

// Board values are present in rows of cycles in which the board replied.
#define DARWINOP_BOARD(field) \
  [](const LogRow& r) { return detail::when(r.sensors.board.motion.fresh(), r.sensors.board.field); }

inline constexpr auto kLogColumns = std::to_array<LogColumn>({
    {"time_s", "", "release time of the cycle, s on the loop's clock",
     [](const LogRow& r) { return static_cast<double>(r.sensors.time_ns) * 1e-9; }},
    {"cycle", "", "number of the cycle, from 1; a gap is a row that was lost",
     [](const LogRow& r) { return static_cast<double>(r.sensors.cycle); }},
    {"loop.wake", "us", "how late the cycle began",
     [](const LogRow& r) { return detail::us(r.sensors.wake_latency_ns); }},
    {"loop.slack", "ms", "time the cycle before had left; negative: overrun",
     [](const LogRow& r) { return detail::ms(r.sensors.slack_ns); }},
    {"loop.overruns", "", "so far", [](const LogRow& r) { return double(r.sensors.overruns); }},
    {"bus.time", "ms", "from the first byte written to the last one decoded",
     [](const LogRow& r) { return detail::ms(r.sensors.wire.bus_ns); }},
    {"bus.wire", "ms", "the same bytes at the baud rate: no cycle can be faster",
     [](const LogRow& r) { return detail::ms(r.sensors.wire.wire_ns); }},
    {"bus.incomplete", "", "bulk reads answered in part or not at all, so far",
     [](const LogRow& r) { return double(r.sensors.link.incomplete); }},
    {"bus.retries", "", "times a silent device was asked again, so far",
     [](const LogRow& r) { return double(r.sensors.link.retries); }},
    {"bus.silent", "", "servos given up on for now",
     [](const LogRow& r) { return static_cast<double>(r.sensors.silent.count()); }},
    {"driver.session", "", "number of the controller that drives, 0: none",
     [](const LogRow& r) { return double(r.asked.session); }},
    {"driver.sequence", "", "counts the images of that controller",
     [](const LogRow& r) { return static_cast<double>(r.asked.sequence); }},
    {"safety.state", "", "see the head of the file",
     [](const LogRow& r) { return static_cast<double>(r.sensors.safety.state); }},
    {"safety.fault", "", "code of the worst active fault, 0: none; see faults.md",
     [](const LogRow& r) { return static_cast<double>(r.sensors.safety.worst); }},
    {"safety.fault_joint", "", "servo id it concerns, 0: none",
     [](const LogRow& r) { return double(r.sensors.safety.worst_joint); }},
    {"gyro.x", "rad/s", "", DARWINOP_BOARD(gyro[0].value)},
    {"gyro.y", "rad/s", "", DARWINOP_BOARD(gyro[1].value)},
    {"gyro.z", "rad/s", "", DARWINOP_BOARD(gyro[2].value)},
    {"accelerometer.x", "m/s2", "", DARWINOP_BOARD(accelerometer[0].value)},
    {"accelerometer.y", "m/s2", "", DARWINOP_BOARD(accelerometer[1].value)},
    {"accelerometer.z", "m/s2", "upright +9.8", DARWINOP_BOARD(accelerometer[2].value)},
    {"board.voltage", "V", "supply", DARWINOP_BOARD(voltage.value)},
    {"board.buttons", "", "1 MODE, 2 START, 3 both", DARWINOP_BOARD(buttons)},
    {"board.servo_power", "", "1: the servos are supplied", DARWINOP_BOARD(servo_power)},
    {"board.errors", "", "error bits of the board's answer", DARWINOP_BOARD(error_bits)},
    {"microphone.left", "", "0..1023", DARWINOP_BOARD(microphone_left)},
});
#undef DARWINOP_BOARD

#define DARWINOP_ASKED(bit, field) \
  [](const JointCommand& a, const JointSensors&) { return detail::when(a.has(JointCommand::bit), a.field); }
#define DARWINOP_SEEN(age, field) \
  [](const JointCommand&, const JointSensors& s) { return detail::when(s.age.fresh(), s.field); }

inline constexpr auto kJointLogColumns = std::to_array<JointLogColumn>({
    {"asked", "rad", "goal the controller asks for, before safety", DARWINOP_ASKED(kGoal, goal.value)},
    {"asked_speed", "rad/s", "speed limit it asks for", DARWINOP_ASKED(kSpeedLimit, speed_limit.value)},
    {"asked_torque", "N m", "torque limit it asks for", DARWINOP_ASKED(kTorqueLimit, torque_limit.value)},
    {"asked_p_gain", "Kp", "P gain it asks for: the servo's register / 8", DARWINOP_ASKED(kPGain, p_gain)},
    {"asked_torque_on", "", "1: torque, 0: limp", DARWINOP_ASKED(kTorque, torque_on)},
    {"commanded", "rad", "goal sent last, after safety; empty while the joint is not driven",
     [](const JointCommand&, const JointSensors& s) { return detail::when(s.driven, s.commanded.value); }},
    {"position", "rad", "measured in this cycle", DARWINOP_SEEN(motion, position.value)},
    {"velocity", "rad/s", "measured in this cycle", DARWINOP_SEEN(motion, velocity.value)},
    {"load", "", "fraction of the greatest torque, -1..1, measured in this cycle", DARWINOP_SEEN(motion, load)},
    {"errors", "", "error bits of the servo's answer in this cycle", DARWINOP_SEEN(motion, error_bits)},
    {"voltage", "V", "when it was this servo's turn", DARWINOP_SEEN(polled, voltage.value)},
    {"temperature", "degC", "when it was this servo's turn", DARWINOP_SEEN(polled, temperature.value)},
    {"torque_enabled", "", "1: torque is on, when it was this servo's turn", DARWINOP_SEEN(polled, torque_enabled)},
});
#undef DARWINOP_ASKED
#undef DARWINOP_SEEN

}  // namespace darwinop::runtime
