// What each servo says of itself, in words.
#include "hal/cm730/servo_rows.hpp"

#include <algorithm>
#include <cstdio>
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

struct ErrorBitRow {
  std::uint8_t bit;
  Level level;
  std::string_view name, mend;
};
constexpr ErrorBitRow kErrorBits[] = {
    {error_bit::kVoltage, Level::kWarning, "voltage", "its supply is outside its limits: check battery and cables"},
    {error_bit::kAngleLimit, Level::kWarning, "angle limit",
     "it was sent a goal outside its own angle limits (registers 6 and 8): check them against docs/registers.md"},
    {error_bit::kOverheat, Level::kError, "overheating",
     "let it cool down, and look for a joint that works against a stop"},
    {error_bit::kRange, Level::kWarning, "range", "it refused a value: check its firmware"},
    {error_bit::kChecksum, Level::kWarning, "checksum", "requests reach it damaged: check the cable that leads to it"},
    {error_bit::kOverload, Level::kError, "overload",
     "free the joint and switch servo power off and on; in a running loop, reset the faults"},
    {error_bit::kInstruction, Level::kWarning, "instruction", "it does not know an instruction: check its firmware"},
};

/// Collects what is wrong with one servo into one row.
class Row {
 public:
  explicit Row(std::string what) : row_{Level::kOk, std::move(what), {}} {}
  void add(Level level, std::string_view problem, std::string_view mend) {
    row_.level = std::max(row_.level, level);
    if (!problem.empty()) row_.what.append("; ").append(problem);
    if (!row_.mend.empty()) row_.mend += "; ";
    row_.mend += mend;
  }
  [[nodiscard]] Finding take() { return std::move(row_); }

 private:
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
    found.add(Level::kOk, "return delay was " + microseconds(servo.return_delay_was) + ", set to 0 for good", {});
  else
    found.add(Level::kWarning,
              "every answer waits " + microseconds(servo.return_delay) + ", " + microseconds(kMostReturnDelay) +
                  " are allowed",
              whyNot(servo.delay_mending));
}

void addStatusLevel(const ServoFacts& servo, Row& found) {
  if (servo.level_mending == Mending::kNotNeeded) return;
  if (servo.level_mending == Mending::kDone)
    found.add(Level::kOk, "status return level set to 2 for good", {});
  else
    found.add(Level::kWarning,
              "status return level " + std::to_string(servo.status_level) +
                  " instead of 2: it does "
                  "not answer to writes",
              whyNot(servo.level_mending));
}

void addHealth(const ServoFacts& servo, Row& found) {
  if (servo.temperature.value >= kTooHot)
    found.add(Level::kError, "too hot", "let it cool to 60 deg C; it shuts itself off at 80");
  else if (servo.temperature.value >= kHot)
    found.add(Level::kWarning, "hot", "give the robot a rest");
  for (const ErrorBitRow& error : kErrorBits)
    if ((servo.error_bits & error.bit) != 0)
      found.add(error.level, "error bit: " + std::string{error.name}, error.mend);
  if (servo.torque_limit == 0)
    found.add(Level::kError, "torque limit is 0: it has shut itself off",
              "remove the cause, then switch servo power off and on; in a running loop, reset the faults");
}

Finding readableRow(Joint joint, const ServoFacts& servo) {
  Row found{summary(joint, servo)};
  if (servo.model != find(kMx28, "model").reset)
    found.add(Level::kError, "model " + std::to_string(servo.model) + " is no MX-28 (29)", "put an MX-28 in its place");
  if (servo.firmware < kOldestFirmware)
    found.add(Level::kError, "firmware is older than 27: 1024 steps a turn and no PID",
              "update its firmware with the vendor's tool");
  if (servo.wheel_mode)
    found.add(Level::kError, "in wheel mode (both angle limits 0): it would turn without end",
              "set its angle limits, registers 6 and 8, to 0 and 4095 with the vendor's tool");
  addReturnDelay(servo, found);
  addStatusLevel(servo, found);
  addHealth(servo, found);
  return found.take();
}

Finding unreadableRow(Joint joint, const ServoFacts& servo) {
  if (!servo.garbled)
    return {Level::kError, servoName(joint) + ": answers to pings only, so its status return level is 0",
            whyNot(servo.level_mending)};
  const std::string what = servoName(joint) + ": its answers are garbled";
  if (row(joint).id == 1)
    return {Level::kError, what,
            "two servos may share id 1, as a replaced one comes with it: look which other one is silent, connect that "
            "one alone and give it its own id; else check the cable"};
  return {Level::kError, what, "check the cable that leads to it, and whether two servos have this id"};
}

Finding silentRow(Joint joint, const RobotFacts& facts) {
  const std::string what = servoName(joint) + ": silent";
  const ChainBreak where = findBreak(facts, row(joint).chain);
  if (!where.first_silent || row(joint).id < row(*where.first_silent).id || where.silent == 1)
    return {Level::kError, what, "check the plugs of this servo; " + replaced(joint)};
  if (joint != *where.first_silent) return {Level::kError, what + ", behind " + servoName(*where.first_silent), {}};
  const std::string from = where.last_heard ? servoName(*where.last_heard) : "the board";
  return {Level::kError, what + ", and so is everything behind it in its chain",
          "check the cable from " + from + " into " + servoName(joint)};
}

}  // namespace

std::string servoName(Joint joint) {
  const JointRow& r = row(joint);
  return "servo " + std::to_string(r.id) + " " + std::string{r.name} + " (" + std::string{r.anatomical} + ")";
}

void addServoRows(const RobotFacts& facts, Findings& rows) {
  if (std::ranges::none_of(facts.servo, [](const ServoFacts& s) { return s.found || s.garbled; })) {
    rows.push_back({Level::kError, "none of the twenty servos answers, though servo power is on",
                    "check the cables from the board to the servos, then the board's servo fuse"});
    return;
  }
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    const ServoFacts& servo = facts.servo[i];
    if (servo.readable)
      rows.push_back(readableRow(joint, servo));
    else if (servo.found || servo.garbled)
      rows.push_back(unreadableRow(joint, servo));
    else
      rows.push_back(silentRow(joint, facts));
  }
}

}  // namespace darwinop::cm730
