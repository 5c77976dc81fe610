// Fault table: cause, reaction of the safety layer, and remedy of each fault. Also limits and states. Log lines,
// docs/faults.md and remote messages use these rows. How to add a fault: CONTRIBUTING.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace darwinop {

/// Latched faults stay until a reset is requested. Numbers are stable: logs and users' scripts contain them.
enum class Fault : std::uint8_t {
  kNone = 0,
  kBusSilent = 10,
  kBoardReset = 11,
  kServoSilent = 12,
  kServoPowerOff = 13,
  kBatteryLow = 20,
  kBatteryEmpty = 21,
  kServoHot = 22,
  kServoOverheat = 23,
  kServoOverload = 24,
  kServoVoltage = 25,
  kEncoderStuck = 26,
  kFell = 30,
  kReleasedByButton = 31,
  kStartMissed = 32,
  kReleasedByOperator = 33,
  kControllerStalled = 40,
  kControllerGone = 41,
};

/// Reactions of the safety layer, in increasing strength.
enum class Reaction : std::uint8_t {
  kReport,       // report only
  kSlow,         // joints move at the gentle speed
  kHold,         // keep the last safe goals
  kKneel,        // slow move to the start pose (sitting), then limp
  kLimp,         // torque off; the robot may drop
  kStopSending,  // nothing is sent to a bus that does not reply
};
inline constexpr std::array<std::string_view, 6> kReactionNames{"report", "slow", "hold",
                                                                "kneel",  "limp", "stop_sending"};

/// Cycles in which the cause of a fault is checked; its times count these cycles only.
enum class Checked : std::uint8_t {
  kAlways,  // each cycle
  kBoard,   // cycles in which the board replies
  kServo,   // cycles in which the servo replies
  kPoll,    // the round-robin poll of the servo's temperature and torque, once a second or more often
};

struct FaultRow {
  Fault fault;
  Reaction reaction;
  bool latched;          // false: ends with its cause
  bool ends_controller;  // true: step() returns -1
  std::string_view name, meaning, remedy;
  // For docs/faults.md only.
  Checked checked;
  std::string_view ends;  // when it ends, or can be reset; empty: when its cause is gone
  std::string_view details = "";
};

// Thresholds are defined in safety/config.hpp; tests/safety/fault_docs_test.cpp compares them with these texts.
inline constexpr auto kFaultTable = std::to_array<FaultRow>({
    {Fault::kBusSilent, Reaction::kStopSending, false, false, "bus_silent",
     "the CM-730 board, or without one the servos, have not answered for more than 5 cycles",
     "check the USB cable and the robot's power switch; the runtime resumes when the board replies", Checked::kAlways,
     "",
     "A loop that stood still for 0.15 s counts as well. Powered servos hold their last goal. At the first answer "
     "joints "
     "continue gently from where they are; without a controller on_exit applies."},
    {Fault::kBoardReset, Reaction::kLimp, true, true, "board_reset",
     "servo power was lost while the robot was under torque: RESET was pressed or the supply dipped",
     "hold the robot, then press START or start the controller again; if RESET was not pressed, check battery and "
     "connector",
     Checked::kBoard, "",
     "Two answers in a row; without a board, half of the servos restart within a second. A joint counts as under "
     "torque "
     "until polled after a torque off (0.4 s); `NAME.held` in `/dev/shm` keeps this across loops."},
    {Fault::kServoSilent, Reaction::kReport, false, false, "servo_silent",
     "a servo has not answered for half a second, or does not store what is written to it",
     "check the cable that leads to the first silent servo of its chain", Checked::kAlways, "",
     "`silent_s` or three requests in a row, not in the first second of servo power; or 20 takeovers in a row (a "
     "second) did not store goal and speed. From the first missed answer on the joint gets no goal: a restarted servo "
     "would move without a speed limit. It continues if the servo kept torque and speed limit, and is taken over "
     "gently otherwise or after 5 cycles. A servo silent at start gets no goals until the next start."},
    {Fault::kServoPowerOff, Reaction::kReport, false, false, "servo_power_off",
     "the CM-730 reports that servo power is off although it was on",
     "nothing: power is switched on again, at most 3 times in 60 s; after that press START or start a controller",
     Checked::kBoard, "", "No joint gets a goal meanwhile."},
    {Fault::kBatteryLow, Reaction::kReport, false, false, "battery_low", "the supply is under 11.0 V for 2 s",
     "charge or change the battery soon", Checked::kBoard, "above 11.3 V for 2 s", "`battery_low`."},
    {Fault::kBatteryEmpty, Reaction::kKneel, true, true, "battery_empty", "the supply is under 10.0 V for 2 s",
     "change the battery, then start the controller again", Checked::kBoard, "above 10.3 V for 2 s",
     "`battery_empty`."},
    {Fault::kServoHot, Reaction::kSlow, false, false, "servo_hot", "a servo is at 65 deg C or more",
     "give the robot a rest; joints move at the gentle speed until it has cooled to 60 deg C", Checked::kPoll,
     "at 60 deg C", "`hot`, in two readings."},
    {Fault::kServoOverheat, Reaction::kKneel, true, true, "servo_overheat",
     "a servo is at 75 deg C or more, or has set its overheating bit (it shuts itself off at 80)",
     "let it cool, look for a joint that works against a stop, then start the controller again", Checked::kPoll,
     "at 70 deg C without the bit", "`overheat`, in two readings, or the bit in two replies; it then gets no goals."},
    {Fault::kServoOverload, Reaction::kKneel, true, true, "servo_overload",
     "a servo has shut itself off: its overload bit is set, or its torque or torque limit is found off",
     "free the joint, then start the controller again: torque limit and torque are restored together", Checked::kServo,
     "once the joint is free",
     "A controller that switches the joint's torque off and on drives it again; the fault stays. The bit in two "
     "replies, torque limit 0 or torque off without a restart in two polls, or torque limit 0 after two "
     "takeovers. From the first suspicion nothing is written to the servo, because a torque limit would switch it on. "
     "Routine writes omit torque limits; while a servo works at 80 % or more of its limit, a changed one is written "
     "without its goal, in one of 8 to 15 cycles. After a reset an overload bit counts from 0.3 s of torque on."},
    {Fault::kServoVoltage, Reaction::kReport, false, false, "servo_voltage",
     "a servo reports a supply outside its limits (6 to 16 V)", "check battery and cables", Checked::kServo,
     "after 1 s", "Lasts 0.1 s."},
    {Fault::kEncoderStuck, Reaction::kReport, false, false, "encoder_stuck",
     "a servo pushed both ways for half a second each, and its position stayed the same to the tick",
     "stop the controller, move the joint by hand and watch its position; if it stays the same, replace the servo",
     Checked::kServo, "", "Pushed: with 0.75 N m or more. A joint clamped from both sides looks the same."},
    {Fault::kFell, Reaction::kReport, false, false, "fell", "the trunk is tilted by more than 60 deg for 0.5 s",
     "stand the robot up; a controller that can get up may do so (set [Safety] on_fall = limp to forbid it)",
     Checked::kBoard, "under 45 deg for 0.5 s",
     "`fall_tilt`. With `on_fall = limp` torque goes off and returns gently."},
    {Fault::kReleasedByButton, Reaction::kLimp, true, true, "released_by_button", "the robot was released with MODE",
     "hold the robot, then press START or start the controller again", Checked::kBoard, "",
     "Held for 0.25 s. `release_button = none` gives it to the controller. A servo silent at start is not released."},
    {Fault::kStartMissed, Reaction::kReport, false, false, "start_missed",
     "a joint did not reach the start pose in the slow move to it",
     "look for what blocks the joint, then start the controller again", Checked::kAlways, "at the next start",
     "Within `start_tolerance`. The controller drives and prints the joint names."},
    {Fault::kReleasedByOperator, Reaction::kLimp, true, true, "released_by_operator",
     "a person released the robot: with `darwinop runtime --release`, or before the runtime was restarted",
     "hold the robot, then press START or start the controller again", Checked::kAlways, "",
     "The previous daemon left the robot released (31, 33) or without power (11)."},
    {Fault::kControllerStalled, Reaction::kHold, false, false, "controller_stalled",
     "the controller has not called step() for 500 ms",
     "the last safe goals are held; motion continues when step() is called", Checked::kAlways, "",
     "`stall_ms`, not in the start move and the first `take_over_s` of a takeover with servo power."},
    {Fault::kControllerGone, Reaction::kKneel, false, true, "controller_gone",
     "the controller has been silent for 10 s and has not ended its session",
     "the robot sits down slowly and releases torque; start the controller again, and if it needs longer than that "
     "between two steps, raise `gone_s` in config.ini",
     Checked::kAlways, "at the next start",
     "`gone_s`. A controller that resumes later neither drives nor switches torque; its `step()` returns -1. After a "
     "regular end `on_exit` applies."},
});

inline constexpr FaultRow kNoFault{Fault::kNone, Reaction::kReport, false, false, "none", "all is well",
                                   "",           Checked::kAlways,  ""};

/// Row of a fault; kNoFault for kNone and for invalid numbers.
constexpr const FaultRow& row(Fault fault) {
  for (const FaultRow& r : kFaultTable)
    if (r.fault == fault) return r;
  return kNoFault;
}
inline constexpr std::size_t kFaults = kFaultTable.size();

/// Limits that safety applies to commands. They are counted and are not faults.
enum class Limit : std::uint8_t {
  kPosition,   // goal outside the joint's range: clamped
  kRate,       // goal further away than the joint may move in one cycle: approached in steps
  kNotFinite,  // NaN or infinity: the previous goal is kept
  kSpeed,      // speed limit out of range: clamped
  kTorque,     // torque limit out of range: clamped
  kGain,       // P gain out of range: clamped
  kCount
};
inline constexpr std::size_t kLimits = static_cast<std::size_t>(Limit::kCount);
inline constexpr std::array<std::string_view, kLimits> kLimitNames{"position", "rate",   "not_finite",
                                                                   "speed",    "torque", "gain"};

/// States of the safety layer. Transitions: safety/states.hpp.
enum class State : std::uint8_t {
  kOffline,     // the board does not reply; nothing is sent
  kLimp,        // torque is off, all sensors are read
  kTakingOver,  // goals are set to the present pose, torque is switched on
  kStarting,    // slow move to the start pose
  kDriven,      // a controller's commands are executed
  kHolding,     // the controller is silent: the last safe goals are held
  kKneeling,    // slow move to the start pose, then limp
  kFoundStiff,  // no session drives, but a servo has torque
  kCount
};
inline constexpr std::size_t kStates = static_cast<std::size_t>(State::kCount);
inline constexpr std::array<std::string_view, kStates> kStateNames{"offline", "limp",    "taking_over", "starting",
                                                                   "driven",  "holding", "kneeling",    "found_stiff"};

/// States in which joints get goals: a session drives, or safety moves the robot.
constexpr bool drives(State state) {
  return state != State::kOffline && state != State::kLimp && state != State::kFoundStiff;
}

}  // namespace darwinop
