// Hash over the fields of the exchange. A controller and a runtime of incompatible builds must not share memory.
#include <cstddef>

#include "core/faults.hpp"
#include "core/joints.hpp"
#include "runtime/exchange.hpp"
#include "runtime/histogram.hpp"
#include "runtime/layout_hash.hpp"

namespace darwinop::runtime {

template <class Tag>
struct Layout<Unit<Tag>> {
  static constexpr void addTo(LayoutHash& hash) { addOpaque<Unit<Tag>>(hash, "Unit"); }
};
template <>
struct Layout<Flag> {
  static constexpr void addTo(LayoutHash& hash) { addOpaque<Flag>(hash, "Flag"); }
};
template <class T>
struct Layout<std::atomic<T>> {
  static constexpr void addTo(LayoutHash& hash) { Layout<T>::addTo(hash.add("atomic")); }
};
template <class T, std::uint32_t kSlots>
struct Layout<Latest<T, kSlots>> {
  static constexpr void addTo(LayoutHash& hash) {
    addOpaque<Latest<T, kSlots>>(hash.add(kSlots), "Latest");
    Layout<T>::addTo(hash);
  }
};
template <>
struct Layout<LoopStats> {
  static constexpr void addTo(LayoutHash& hash) {
    addOpaque<LoopStats>(hash.add(Bins::kExact).add(Bins::kPerOctave).add(Bins::kOctaves), "LoopStats");
  }
};
template <>
struct Layout<WakeWord> {
  static constexpr void addTo(LayoutHash& hash) { addOpaque<WakeWord>(hash, "WakeWord"); }
};
template <>
struct Layout<WaitNote> {
  static constexpr void addTo(LayoutHash& hash) { addOpaque<WaitNote>(hash, "WaitNote"); }
};
template <>
struct Layout<RequestWord> {
  static constexpr void addTo(LayoutHash& hash) { addOpaque<RequestWord>(hash, "RequestWord"); }
};

DARWINOP_LAYOUT(JointCommand, set, torque_on, goal, speed_limit, torque_limit, p_gain);
DARWINOP_LAYOUT(LedCommand, set, panel, head, eye);
DARWINOP_LAYOUT(SessionSettings, numbers, given);
DARWINOP_LAYOUT(Commands, joint, led, session, sequence, made_ns, end_of_session, hold, fault_resets, start_where_it_is,
                unattended, settings, loop_ends, operator_resets, operator_releases);

DARWINOP_LAYOUT(Freshness, age);
DARWINOP_LAYOUT(JointSensors, motion, position, velocity, load, error_bits, polled, voltage, temperature, torque_limit,
                goal, speed_limit, torque_enabled, commanded, driven);
DARWINOP_LAYOUT(BoardSensors, absent, motion, gyro, accelerometer, buttons, buttons_known, voltage, microphone_left,
                servo_power, led_panel, led_head, led_eye, error_bits);
DARWINOP_LAYOUT(LinkCounters, exchanges, incomplete, retries, bad_checksums, garbage_bytes, late_replies, reconnects,
                clamped_goals);
DARWINOP_LAYOUT(WireFigures, bytes_out, bytes_in, wire_ns, bus_ns);
DARWINOP_LAYOUT(SafetyReport, state, active, worst, worst_joint, reaction, limit_hits, controller_must_end, session,
                tripped, missed_start, start_timeouts, gentle_speed, default_p_gain, default_speed, at_end);
DARWINOP_LAYOUT(Sensors, cycle, time_ns, period_ns, wake_latency_ns, slack_ns, overruns, joint, bus, board, link, wire,
                safety, silent);

DARWINOP_LAYOUT(LoopInfo, period_ns, pid, robot, port, safety, safety_named);
DARWINOP_LAYOUT(ExchangeBlock, magic, size, layout, instance, info, sensors, finished, closing, session, released,
                refused, stats);
DARWINOP_LAYOUT(CommandBlock, instance, commands, session_taken, fault_reset, release, wait);

namespace {

/// Includes the table rows that indices and bits refer to.
constexpr std::uint64_t hashOfExchange() {
  LayoutHash hash;
  Layout<ExchangeBlock>::addTo(hash);
  Layout<CommandBlock>::addTo(hash);
  for (const JointRow& joint : kJointTable) hash.add(joint.name);
  for (const FaultRow& fault : kFaultTable) hash.add(fault.name).add(static_cast<std::uint64_t>(fault.fault));
  for (const auto& state : kStateNames) hash.add(state);
  return hash.value();
}

}  // namespace

std::uint64_t exchangeLayout() {
  static constexpr std::uint64_t kHash = hashOfExchange();
  return kHash;
}

}  // namespace darwinop::runtime
