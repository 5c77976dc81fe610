// What each servo says of itself, in words.
#include "hal/cm730/servo_rows.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "core/packet.hpp"
#include "core/registers.hpp"
#include "hal/cm730/chains.hpp"
#include "hal/cm730/diagnosis.hpp"

namespace darwinop::cm730 {
namespace {

constexpr double kHot = 65, kTooHot = 75;  // deg C; faults servo_hot and servo_overheat
constexpr int kMicrosecondsPerCount = 2;
// How far a servo's own limits may shift the start pose: 0.15 rad, as near as a start move has to come
// ([Safety] start_tolerance).
constexpr int kMostStartShift = 98;

struct ErrorBitRow {
  std::uint8_t bit;
  Kind kind;
  std::string_view name, mend;
};
constexpr ErrorBitRow kErrorBits[] = {
    {error_bit::kVoltage, Kind::kServoErrorBit, "voltage",
     "its supply is outside its limits: check battery and cables"},
    {error_bit::kAngleLimit, Kind::kServoErrorBit, "angle limit",
     "it was sent a goal outside its own angle limits (registers 6 and 8): check them against docs/registers.md"},
    {error_bit::kOverheat, Kind::kServoOverheatBit, "overheating",
     "let it cool down, and look for a joint that works against a stop"},
    {error_bit::kRange, Kind::kServoErrorBit, "range", "it refused a value: check its firmware"},
    {error_bit::kChecksum, Kind::kServoErrorBit, "checksum",
     "requests reach it damaged: check the cable that leads to it"},
    {error_bit::kOverload, Kind::kServoOverloadBit, "overload",
     "free the joint and switch servo power off and on; in a running loop, reset the faults"},
    {error_bit::kInstruction, Kind::kServoErrorBit, "instruction",
     "it does not know an instruction: check its firmware"},
};

/// Collects what is wrong with one servo into one row.
class Row {
 public:
  Row(Joint joint, std::string what) : row_{Finding::ok(std::move(what))} { row_.joint = joint; }
  void add(Kind kind, std::string_view problem, std::string_view mend) {
    row_.level = std::max(row_.level, levelOf(kind));
    row_.kinds.set(static_cast<std::size_t>(kind));
    append("; ", problem);
    if (!row_.mend.empty()) row_.mend += "; ";
    row_.mend += mend;
  }
  /// What is well now.
  void note(std::string_view text) { append("; ", text); }
  [[nodiscard]] Finding take() { return std::move(row_); }

 private:
  void append(std::string_view separator, std::string_view text) {
    if (!text.empty()) row_.what.append(separator).append(text);
  }
  Finding row_;
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

std::string replaced(Joint joint) {
  return "a replaced servo comes with id 1 and 57142 baud: connect it alone and give it id " +
         std::to_string(row(joint).id) + " and 1 Mbaud with the vendor's tool";
}

/// The sentence for a setting that should have been mended; nothing when it was.
std::string whyNot(Mending mending) {
  switch (mending) {
    case Mending::kNotNeeded:
    case Mending::kDone:
      return {};
    case Mending::kNotAsked:
      return "`darwinop doctor --fix` sets it";
    case Mending::kTorqueOn:
      return "its torque is on, and an MX-28 takes such a setting only while limp: hold the robot, press the board's "
             "RESET button (torque goes off) and run `darwinop doctor --fix`";
    case Mending::kRefused:
      return "it refused the new value: press the board's RESET button to unlock its settings and try again";
  }
  return {};
}

void addReturnDelay(const ServoFacts& servo, Row& found) {
  if (servo.delay_mending == Mending::kNotNeeded) return;
  if (servo.delay_mending == Mending::kDone)
    found.note("return delay was " + microseconds(servo.return_delay_was) + ", set to 0 for good");
  else
    found.add(Kind::kReturnDelay,
              "every answer waits " + microseconds(servo.return_delay) + ", " + microseconds(kMostReturnDelay) +
                  " are allowed",
              whyNot(servo.delay_mending));
}

void addStatusLevel(const ServoFacts& servo, Row& found) {
  if (servo.level_mending == Mending::kNotNeeded) return;
  if (servo.level_mending == Mending::kDone)
    found.note("status return level set to 2 for good");
  else
    found.add(Kind::kStatusLevel,
              "status return level " + std::to_string(servo.status_level) +
                  " instead of 2: it does "
                  "not answer to writes",
              whyNot(servo.level_mending));
}

void addHealth(const ServoFacts& servo, Row& found) {
  if (servo.temperature.value >= kTooHot)
    found.add(Kind::kServoTooHot, "too hot", "let it cool to 60 deg C; it shuts itself off at 80");
  else if (servo.temperature.value >= kHot)
    found.add(Kind::kServoHot, "hot", "give the robot a rest");
  for (const ErrorBitRow& error : kErrorBits)
    if ((servo.error_bits & error.bit) != 0) found.add(error.kind, "error bit: " + std::string{error.name}, error.mend);
  if (servo.max_torque == 0)
    found.add(Kind::kMaxTorqueZero, "max torque (register 14) is 0: it never has torque",
              "set register 14 to 1023 with the vendor's tool");
  else if (servo.torque_limit == 0)
    found.add(Kind::kTorqueLimitZero, "torque limit is 0: it has shut itself off, or a program has set it",
              "remove the cause, then switch servo power off and on; a loop writes it anew when it takes over");
}

std::string radians(Joint joint, const RobotFacts& facts, TickRange ticks) {
  const int offset = facts.start[index(joint)] - row(joint).start;
  char text[64];
  std::snprintf(text, sizeof text, "%.3f to %.3f rad", radFromTicks(ticks.low - offset).value,
                radFromTicks(ticks.high - offset).value);
  return text;
}

/// The servo's own limits against the angles that it may be sent to.
void addRange(Joint joint, const RobotFacts& facts, Row& found) {
  constexpr const char* kVendor = "set registers 6 and 8 with the vendor's tool; factory settings are 0 and 4095";
  const ServoFacts& servo = facts.servo[index(joint)];
  if (servo.wheelMode()) {
    found.add(Kind::kWheelMode, "in wheel mode (both angle limits 0): it would turn without end",
              "set its angle limits, registers 6 and 8, to 0 and 4095 with the vendor's tool");
    return;
  }
  if (servo.multiTurnMode()) {
    found.add(Kind::kMultiTurnMode, "in multi-turn mode (both angle limits 4095): it counts more than one turn",
              "set its angle limits, registers 6 and 8, to 0 and 4095 with the vendor's tool");
    return;
  }
  const TickRange allowed = facts.allowed[index(joint)];
  const TickRange both{std::max<int>(allowed.low, servo.cw_limit), std::min<int>(allowed.high, servo.ccw_limit)};
  const std::string own = "its own limits (registers 6 and 8) allow " +
                          radians(joint, facts, {servo.cw_limit, servo.ccw_limit}) + ", the settings " +
                          radians(joint, facts, allowed);
  if (both.low >= both.high) {
    found.add(Kind::kNoRange, own + ": nothing is in both", kVendor);
    return;
  }
  if (both.low == allowed.low && both.high == allowed.high) return;
  const int start = std::clamp(facts.start[index(joint)], allowed.low, allowed.high);
  if (std::abs(std::clamp(start, both.low, both.high) - start) > kMostStartShift)
    found.add(Kind::kStartPoseOutside, own + "; the start pose is outside: it could not sit down", kVendor);
  else
    found.add(Kind::kNarrowRange, own + ": both hold", kVendor);
}

void addInstructions(const ServoFacts& servo, Row& found) {
  constexpr const char* kCheck = "check its firmware and the cable that leads to it";
  if (!servo.bulk_read_works) found.add(Kind::kServoInstruction, "it answers to READ and not to BULK_READ", kCheck);
  if (!servo.sync_write_works) found.add(Kind::kServoInstruction, "it does not obey SYNC_WRITE", kCheck);
}

Finding readableRow(Joint joint, const RobotFacts& facts) {
  const ServoFacts& servo = facts.servo[index(joint)];
  Row found{joint, summary(joint, servo)};
  if (servo.model != find(kMx28, "model").reset)
    found.add(Kind::kServoModel, "unsupported model " + std::to_string(servo.model) + ", an MX-28 is 29",
              "put an MX-28 in its place");
  if (servo.firmware < kOldestFirmware)
    found.add(Kind::kServoFirmware, "firmware is older than 27: 1024 steps a turn and no PID",
              "update its firmware with the vendor's tool");
  addRange(joint, facts, found);
  addInstructions(servo, found);
  addReturnDelay(servo, found);
  addStatusLevel(servo, found);
  addHealth(servo, found);
  return found.take();
}

Finding unreadableRow(Joint joint, const ServoFacts& servo) {
  if (!servo.garbled)
    return Finding::of(Kind::kServoUnreadable,
                       servoName(joint) + ": answers to pings only, so its status return level is 0",
                       whyNot(servo.level_mending));
  const std::string what = servoName(joint) + ": its answers are garbled";
  if (row(joint).id == 1)
    return Finding::of(
        Kind::kServoGarbled, what,
        "two servos may share id 1, as a replaced one comes with it: look which other one is silent, connect that "
        "one alone and give it its own id; else check the cable");
  return Finding::of(Kind::kServoGarbled, what,
                     "check the cable that leads to it, and whether two servos have this id");
}

Finding silentRow(Joint joint, const RobotFacts& facts) {
  const Kind kind = isLeg(joint) ? Kind::kLegServoSilent : Kind::kServoSilent;
  const std::string what = servoName(joint) + ": silent";
  const std::string permit =
      isLeg(joint) ? "; if the robot lacks it for good: [Robot] absent in robot.ini" : std::string{};
  const ChainBreak where = findBreak(facts, row(joint).chain);
  if (!where.first_silent || row(joint).id < row(*where.first_silent).id || where.silent == 1)
    return Finding::of(kind, what, "check the plugs of this servo; " + replaced(joint) + permit);
  if (joint != *where.first_silent) return Finding::of(kind, what + ", behind " + servoName(*where.first_silent), {});
  const std::string from = where.last_heard ? servoName(*where.last_heard) : "the board";
  return Finding::of(kind, what + ", and so is everything behind it in its chain",
                     "check the cable from " + from + " into " + servoName(joint) + permit);
}

}  // namespace

std::string servoName(Joint joint) {
  const JointRow& r = row(joint);
  return "servo " + std::to_string(r.id) + " " + std::string{r.name} + " (" + std::string{r.anatomical} + ")";
}

void addServoRows(const RobotFacts& facts, Findings& rows) {
  if (std::ranges::none_of(facts.servo, [](const ServoFacts& s) { return s.found || s.garbled; })) {
    rows.push_back(Finding::of(Kind::kNoServo, "none of the twenty servos answers, though servo power is on",
                               "check the cables from the board to the servos, then the board's servo fuse"));
    return;
  }
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    const ServoFacts& servo = facts.servo[i];
    if (servo.absent)
      rows.push_back(Finding::ok(servoName(joint) + ": absent, as robot.ini says; not asked and not driven"));
    else if (servo.readable)
      rows.push_back(readableRow(joint, facts));
    else if (servo.found || servo.garbled)
      rows.push_back(unreadableRow(joint, servo));
    else
      rows.push_back(silentRow(joint, facts));
    rows.back().joint = joint;
  }
}

}  // namespace darwinop::cm730
