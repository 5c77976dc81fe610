// Sensor image after a cycle. A value not received is never zero: it is NaN or old, and every device has an age.
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "core/faults.hpp"
#include "core/joints.hpp"
#include "core/units.hpp"

namespace darwinop {

/// Age of a measurement in cycles. 0: received in the cycle of the image (for safety, the previous cycle). The periods
/// in which the loop stood still count as cycles if it stood still for 0.15 s or longer (runtime/cycle.cpp).
struct Freshness {
  static constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();
  /// Single lost replies are normal on this bus. Controllers get NaN from this age on, at 16 ms after 64 ms.
  static constexpr std::uint32_t kStale = 4;
  std::uint32_t age = kNever;

  [[nodiscard]] constexpr bool fresh() const { return age == 0; }
  [[nodiscard]] constexpr bool stale() const { return age >= kStale; }
  [[nodiscard]] constexpr bool ever() const { return age != kNever; }
  constexpr void received() { age = 0; }
  constexpr void missed(std::uint32_t cycles = 1) {
    if (ever()) age += std::min(cycles, kNever - 1 - age);
  }
};

/// Replies in a row that may be missing. After more, the link counts as lost (board), or the servo is taken over again.
inline constexpr std::uint32_t kAnswerPatience = 5;  // cycles
/// The bus polls one servo per cycle (voltage, temperature, torque). After this many cycles each was polled
/// once, with a margin for lost replies.
inline constexpr std::uint32_t kPollRound = kJoints + 5;

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Values are the last ones received; NaN before the first. `motion` and `polled` are their ages.
struct JointSensors {
  Freshness motion;             // age of position, velocity, load, error_bits
  Rad position;                 // rad
  RadPerSec velocity;           // rad/s
  double load = kUnknown;       // fraction of kMaxTorqueNm, for every servo model; positive pushes counter-clockwise
  std::uint8_t error_bits = 0;  // error byte of the last status packet, see error_bit

  Freshness polled;  // age of the values below, from the last round-robin poll (at least once a second)
  Volt voltage;
  Celsius temperature;
  NewtonMeter torque_limit;  // register value; 0 after the servo shut itself off
  Rad goal;                  // register value
  RadPerSec speed_limit;     // register value; 0: unlimited, as after power-up; never written
  bool torque_enabled = false;

  Rad commanded;        // last goal sent, after safety; NaN while the joint is not driven
  bool driven = false;  // true: the joint gets goals
};

struct BoardSensors {
  /// Servos alone on an adapter: nothing here is ever received, and servo power is unknown.
  bool absent = false;
  Freshness motion;                           // age of all values here
  std::array<RadPerSec, 3> gyro;              // x, y, z, rad/s
  std::array<MeterPerSec2, 3> accelerometer;  // x, y, z, m/s2; upright 0, 0, +9.8
  std::uint8_t buttons = 0;                   // 1 MODE, 2 START
  bool buttons_known = true;                  // false: the source of these values has no buttons
  Volt voltage;
  double microphone_left = kUnknown;  // 0..1023
  bool servo_power = false;
  std::uint8_t led_panel = 0;
  std::uint16_t led_head = 0, led_eye = 0;
  std::uint8_t error_bits = 0;
};

/// Cumulative since the loop started.
struct LinkCounters {
  std::uint32_t exchanges = 0;   // BulkReads sent
  std::uint32_t incomplete = 0;  // of these, with missing replies
  std::uint32_t retries = 0;     // repeated requests to a device that did not reply
  std::uint32_t bad_checksums = 0;
  std::uint32_t garbage_bytes = 0;
  std::uint32_t late_replies = 0;  // replies to an earlier request, discarded
  std::uint32_t reconnects = 0;
  std::uint32_t clamped_goals = 0;  // clamped to the joint table's range when encoded; 0 unless there is a bug
};

/// Bus statistics of one cycle.
struct WireFigures {
  std::uint32_t bytes_out = 0, bytes_in = 0;
  std::int64_t wire_ns = 0;  // transmission time at the baud rate: lower bound of bus_ns
  std::int64_t bus_ns = 0;   // from the first byte written to the last byte decoded
};

struct SafetyReport {
  State state = State::kOffline;
  std::bitset<kFaults> active;   // by row of kFaultTable
  Fault worst = Fault::kNone;    // active fault with the strongest reaction, first of equals
  std::uint8_t worst_joint = 0;  // servo id of that fault, 0: none
  Reaction reaction = Reaction::kReport;
  std::array<std::uint32_t, kLimits> limit_hits{};  // cumulative, all joints
  bool controller_must_end = false;
  std::uint32_t session = 0;          // session that drives
  std::bitset<kJoints> tripped;       // shut themselves off; not driven until a reset is requested
  std::bitset<kJoints> missed_start;  // did not reach the start pose in time in the last move to it
  std::uint32_t start_timeouts = 0;   // moves to the start pose that timed out

  // Settings in force: the robot's and the session's together. NaN: not known, as from a server of 2013.
  float gentle_speed = std::numeric_limits<float>::quiet_NaN();    // rad/s
  float default_p_gain = std::numeric_limits<float>::quiet_NaN();  // of a joint that was given none
  float default_speed = std::numeric_limits<float>::quiet_NaN();   // rad/s, of a joint that was given none
  Reaction at_end = Reaction::kKneel;                              // [Safety] on_exit
};

struct Sensors {
  std::uint64_t cycle = 0;           // counts from 1; 0: no cycle has run
  std::int64_t time_ns = 0;          // release time of the cycle on the loop's clock
  std::int64_t period_ns = 0;        // nominal
  std::int64_t wake_latency_ns = 0;  // how late the cycle began
  std::int64_t slack_ns = 0;         // time left before the next release, of the previous cycle
  std::uint32_t overruns = 0;        // cycles that ended after the next release, cumulative
  std::array<JointSensors, kJoints> joint{};
  Freshness bus;  // age of the last answer that shows a working line: the board's, without a board the first servo's
  BoardSensors board{};
  LinkCounters link{};
  WireFigures wire{};
  SafetyReport safety{};
  std::bitset<kJoints> silent;  // servos removed from the read list for now; retried every 16 to 48 cycles
};
static_assert(std::is_trivially_copyable_v<Sensors>);

}  // namespace darwinop
