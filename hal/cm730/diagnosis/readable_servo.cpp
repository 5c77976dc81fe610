// Findings about a servo whose registers were read.
#include "hal/cm730/diagnosis/readable_servo.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/packet.hpp"
#include "core/registers.hpp"
#include "core/servo_limits.hpp"
#include "core/servo_models.hpp"
#include "hal/cm730/diagnosis/bus_faults.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/servo_row.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"

namespace darwinop::cm730 {
namespace {

constexpr int kMicrosecondsPerCount = 2;
// Maximum shift of the start pose by the servo's own limits: 0.15 rad, the tolerance of a start move ([Safety]
// start_tolerance).
constexpr int kMostStartShift = 98;

struct ErrorBitRow {
  std::uint8_t bit;
  Kind kind;
  std::string_view name, remedy;
};
constexpr ErrorBitRow kErrorBits[] = {
    {error_bit::kVoltage, Kind::kServoErrorBit, "voltage", "supply voltage out of range: check battery and cables"},
    {error_bit::kAngleLimit, Kind::kServoErrorBit, "angle limit",
     "a goal was outside its angle limits (registers 6 and 8): compare them with docs/registers.md"},
    {error_bit::kOverheat, Kind::kServoOverheatBit, "overheating", row(BusFault::kServoHot).remedy},
    {error_bit::kRange, Kind::kServoErrorBit, "range", "it rejected a value: check its firmware"},
    {error_bit::kChecksum, Kind::kServoErrorBit, "checksum",
     "it receives damaged requests: check the cable that leads to it"},
    {error_bit::kOverload, Kind::kServoOverloadBit, "overload",
     "free the joint and switch servo power off and on; in a running loop, reset the faults"},
    {error_bit::kInstruction, Kind::kServoErrorBit, "instruction", "unknown instruction: check its firmware"},
};

std::string microseconds(int counts) {
  return std::to_string(counts * kMicrosecondsPerCount) + " us";
}

std::string summary(Joint joint, const ServoFacts& servo) {
  char text[160];
  std::snprintf(text, sizeof text, ": firmware %d, return delay %d us, %.0f deg C, %.1f V, torque limit %.0f %%, %s",
                servo.firmware, servo.return_delay * kMicrosecondsPerCount, servo.temperature.value,
                servo.voltage.value, servo.torque_limit / 10.23, servo.torque_on ? "torque on" : "limp");
  return servoName(joint) + text;
}

void addReturnDelay(const ServoFacts& servo, ServoRow& found) {
  if (servo.delay_correction == Correction::kNotNeeded) return;
  if (servo.delay_correction == Correction::kDone)
    found.note("return delay was " + microseconds(servo.return_delay_was) + ", set to 0 permanently");
  else
    found.add(
        Kind::kReturnDelay,
        "return delay is " + microseconds(servo.return_delay) + " (maximum " + microseconds(kMostReturnDelay) + ")",
        correctionRemedy(servo.delay_correction));
}

void addStatusLevel(const ServoFacts& servo, ServoRow& found) {
  if (servo.level_correction == Correction::kNotNeeded) return;
  if (servo.level_correction == Correction::kDone)
    found.note(servo.was_mute ? kMuteCorrected : kStatusLevelCorrected);
  else
    found.add(
        Kind::kStatusLevel,
        "status return level " + std::to_string(servo.status_level) + " instead of 2: it does not acknowledge writes",
        correctionRemedy(servo.level_correction));
}

std::string coolDown() {
  char text[80];
  std::snprintf(text, sizeof text, "let it cool to %.0f deg C; it shuts down at %.0f", kServoHotC - kHeatHysteresis,
                kServoShutdownC);
  return text;
}

void addHealth(const ServoFacts& servo, ServoRow& found) {
  if (servo.temperature.value >= kServoOverheatC)
    found.add(Kind::kServoTooHot, "too hot", coolDown());
  else if (servo.temperature.value >= kServoHotC)
    found.add(Kind::kServoHot, "hot", "let the robot cool down");
  for (const ErrorBitRow& error : kErrorBits)
    if ((servo.error_bits & error.bit) != 0)
      found.add(error.kind, "error bit: " + std::string{error.name}, error.remedy);
  if (servo.max_torque == 0)
    found.add(Kind::kMaxTorqueZero, "max torque (register 14) is 0: no torque", row(BusFault::kMaxTorqueZero).remedy);
  else if (servo.torque_limit == 0)
    found.add(Kind::kTorqueLimitZero, "torque limit is 0: set by its shutdown or by a program",
              "remove the cause, then switch servo power off and on; a loop writes it again at takeover");
}

std::string radians(Joint joint, const RobotFacts& facts, TickRange ticks) {
  const int offset = facts.start[index(joint)] - row(joint).start;
  char text[64];
  std::snprintf(text, sizeof text, "%.3f to %.3f rad", radFromTicks(ticks.low - offset).value,
                radFromTicks(ticks.high - offset).value);
  return text;
}

constexpr const char* kFactoryLimits = "set its angle limits, registers 6 and 8, to 0 and 4095 with the vendor's tool";

/// Compares the servo's own limits with the allowed goals.
void addRange(Joint joint, const RobotFacts& facts, ServoRow& found) {
  constexpr const char* kVendor = "set registers 6 and 8 with the vendor's tool; factory settings are 0 and 4095";
  const ServoFacts& servo = facts.servo[index(joint)];
  if (servo.wheelMode()) {
    found.add(Kind::kWheelMode, "in wheel mode (both angle limits 0): it would turn continuously", kFactoryLimits);
    return;
  }
  if (servo.multiTurnMode()) {
    found.add(Kind::kMultiTurnMode, "in multi-turn mode (both angle limits 4095): it counts more than one turn",
              kFactoryLimits);
    return;
  }
  const TickRange allowed = facts.allowed[index(joint)];
  const TickRange both{std::max<int>(allowed.low, servo.cw_limit), std::min<int>(allowed.high, servo.ccw_limit)};
  const std::string own = "its own limits (registers 6 and 8) allow " +
                          radians(joint, facts, {servo.cw_limit, servo.ccw_limit}) + ", the settings " +
                          radians(joint, facts, allowed);
  if (both.low >= both.high) {
    found.add(Kind::kNoRange, own + ": they do not overlap", kVendor);
    return;
  }
  if (both.low == allowed.low && both.high == allowed.high) return;
  const int start = std::clamp(facts.start[index(joint)], allowed.low, allowed.high);
  if (std::abs(std::clamp(start, both.low, both.high) - start) > kMostStartShift)
    found.add(Kind::kStartPoseOutside, own + "; the start pose is outside, so the robot could not sit down", kVendor);
  else
    found.add(Kind::kNarrowRange, own + ": the intersection applies", kVendor);
}

void addInstructions(const ServoFacts& servo, ServoRow& found) {
  constexpr const char* kCheck = "check its firmware and the cable that leads to it";
  if (!servo.bulk_read_works) found.add(Kind::kServoInstruction, "answers READ but not BULK_READ", kCheck);
  if (!servo.sync_write_works) found.add(Kind::kServoInstruction, "does not execute SYNC_WRITE", kCheck);
}

void addModel(const ServoFacts& servo, const Permitted& permitted, ServoRow& found) {
  const ServoModel* const model = findServoModel(servo.model);
  const std::string number = std::to_string(servo.model), replace = "replace it by an MX-28";
  if (model == nullptr) {
    found.add(Kind::kServoModel, "unsupported model " + number + " (expected 29, MX-28)", replace);
    return;
  }
  const std::string name{model->name};
  if (!isDriven(*model, permitted.servo_models)) {
    found.add(Kind::kServoModel, "unsupported model " + number + " (" + name + "; expected 29, MX-28)",
              model->use == ServoUse::kRefused
                  ? "install firmware of protocol 1.0 (model 29) with the vendor's tool, or replace it by an MX-28"
                  : replace + ", or permit it in robot.ini: [Robot] servo_models = " + name);
    return;
  }
  if (model->use == ServoUse::kIfPermitted) {
    char text[80];
    std::snprintf(text, sizeof text, "%s, permitted by robot.ini, at most %.1f of its %.1f N m", name.c_str(),
                  kMaxTorqueNm, model->stall_torque);
    found.note(text);
  }
  if (servo.slave_mode)
    found.add(Kind::kServoMode,
              "its drive mode (register 10) is not 0: it follows another servo or turns the other way",
              "set register 10 to 0 with the vendor's tool");
  if (servo.torque_control)
    found.add(Kind::kServoMode, "in torque control mode (register 70), or this cannot be read: goals do not stop it",
              "hold the robot, switch servo power off and on");
}

}  // namespace

std::string correctionRemedy(Correction correction) {
  switch (correction) {
    case Correction::kNotNeeded:
    case Correction::kDone:
      return {};
    case Correction::kNotAsked:
      return "run `darwinop doctor --fix`";
    case Correction::kTorqueOn:
      return "its torque is on, and an MX-28 accepts this setting only without torque: hold the robot, press the "
             "board's RESET button (torque goes off) and run `darwinop doctor --fix`";
    case Correction::kRefused:
      return "it rejected the new value: press the board's RESET button to unlock its settings and try again";
  }
  return {};
}

Finding readableRow(Joint joint, const RobotFacts& facts) {
  const ServoFacts& servo = facts.servo[index(joint)];
  ServoRow found{joint, summary(joint, servo)};
  addModel(servo, facts.permitted, found);
  const ServoModel* const model = findServoModel(servo.model);
  if (servo.firmware < (model != nullptr ? model->oldest_firmware : kOldestFirmware))
    found.add(Kind::kServoFirmware, "firmware is older than 27: 1024 steps per turn and no PID",
              "update its firmware with the vendor's tool");
  addRange(joint, facts, found);
  addInstructions(servo, found);
  addReturnDelay(servo, found);
  addStatusLevel(servo, found);
  addHealth(servo, found);
  return found.take();
}

}  // namespace darwinop::cm730
