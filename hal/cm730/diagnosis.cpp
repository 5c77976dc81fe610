// Findings about the board, the line and the cycle as a whole. Servos: servo_rows.cpp.
#include "hal/cm730/diagnosis.hpp"

#include <algorithm>
#include <cstdio>

#include "core/registers.hpp"
#include "hal/cm730/servo_rows.hpp"
#include "hal/cm730/usb_serial.hpp"
#include "hal/cm730/wire.hpp"

namespace darwinop::cm730 {
namespace {

constexpr Nanos kPeriod{16'000'000};
constexpr Nanos kHeadroom{1'000'000};  // of a period, for waking up late and computing
constexpr Nanos kDelayUnit{2'000};
constexpr double kBatteryLow = 11.0, kBatteryEmpty = 10.0;  // V; faults battery_low and battery_empty
constexpr std::size_t kSyncWriteBytes = 188;                // gains, goal, speed, torque limit of twenty servos
constexpr std::size_t kRequestBytes = kFrameOverhead + 1 + 3 * (kJoints + 1);

template <class... Args>
std::string format(const char* pattern, Args... args) {
  char text[200];
  std::snprintf(text, sizeof text, pattern, args...);
  return text;
}

double ms(Nanos time) {
  return static_cast<double>(time.count()) * 1e-6;
}

Nanos returnDelays(const RobotFacts& facts) {
  Nanos sum{0};
  for (const ServoFacts& servo : facts.servo)
    if (servo.readable) sum += kDelayUnit * servo.return_delay;
  return sum;
}

Nanos usbTime(const RobotFacts& facts) {
  constexpr std::size_t kShortRead = 8 + 8;
  return std::max(Nanos{0}, facts.round_trip - wireTime(kShortRead));
}

constexpr std::size_t cycleBytes() {
  return kSyncWriteBytes + kRequestBytes + kBoardWindow.frameBytes() + kServoLook.frameBytes() +
         (kJoints - 1) * kServoWindow.frameBytes();
}

Finding silentBoard(const RobotFacts& facts) {
  if (facts.board.garbled)
    return {Level::kError, "bytes come from " + facts.port + ", but they are no answers of a CM-730",
            "check that this is the robot's port, that no other program uses it, and that the cable is sound"};
  if (facts.board.found)
    return {Level::kError, "a CM-730 answers on " + facts.port + ", but its registers cannot be read",
            "press the board's RESET button and try again; if that does not help, look at the USB cable"};
  return {Level::kError, "no CM-730 answers on " + facts.port,
          "switch the robot on and check the USB cable inside it; the board's LEDs must be lit"};
}

void addBoard(const RobotFacts& facts, Findings& rows) {
  const BoardFacts& board = facts.board;
  if (!board.readable) {
    rows.push_back(silentBoard(facts));
    return;
  }
  rows.push_back({Level::kOk, format("CM-730 found, firmware 0x%02X", board.firmware), {}});
  if (board.model != find(kCm730, "model").reset)
    rows.push_back({Level::kWarning, format("the board says it is model 0x%04X, a CM-730 is 0x7300", board.model),
                    "expect other sensors and registers than those of a DARwIn-OP"});
  const std::string volts = format("supply %.1f V", board.voltage.value);
  if (board.voltage.value < kBatteryEmpty)
    rows.push_back({Level::kError, volts + ": empty", "change the battery or plug in the power supply"});
  else if (board.voltage.value < kBatteryLow)
    rows.push_back({Level::kWarning, volts + ": low", "charge or change the battery soon"});
  else
    rows.push_back({Level::kOk, volts, {}});
  if (!board.power_on)
    rows.push_back({Level::kError, "servo power is off and does not come on",
                    "check battery and power switch, press the board's RESET button and try again"});
  else
    rows.push_back({Level::kOk, board.power_was_on ? "servo power is on" : "servo power was off; switched on", {}});
}

void addRoundTrip(const RobotFacts& facts, Findings& rows) {
  if (facts.round_trip_reads == 0) {
    rows.push_back({Level::kError, "no short read was answered at the first try: the line is too noisy to be timed",
                    "check the USB cable and its plugs on both ends"});
    return;
  }
  const std::string what =
      format("a short read takes %.2f ms (median of %d)", ms(facts.round_trip), facts.round_trip_reads);
  if (facts.round_trip < kLatencySignature)
    rows.push_back({Level::kOk, what, {}});
  else
    rows.push_back({Level::kError, what + ": the port's FTDI chip holds bytes back, and a 16 ms cycle cannot hold",
                    latencyCommand(facts.port) + "   (for good: the udev rule in docs/doctor.md)"});
}

void addCycle(const RobotFacts& facts, Findings& rows) {
  const Nanos delays = returnDelays(facts), cycle = cycleTime(facts);
  const std::string what =
      format("a full cycle takes %.1f ms of 16: %.2f on the wire, %.1f of return delays, %.1f of USB", ms(cycle),
             ms(wireTime(cycleBytes())), ms(delays), ms(2 * usbTime(facts)));
  if (cycle <= kPeriod - kHeadroom)
    rows.push_back({Level::kOk, what, {}});
  else if (delays > 2 * usbTime(facts))
    rows.push_back({Level::kError, what + ": too long",
                    "set the return delays to 0: `darwinop doctor --fix` while torque is off"});
  else
    rows.push_back({Level::kError, what + ": too long", latencyCommand(facts.port)});
}

void addLosses(const RobotFacts& facts, Findings& rows) {
  int reads = 0, losses = 0;
  std::size_t worst_servo = 0;
  for (std::size_t i = 0; i < kJoints; ++i) {
    reads += facts.servo[i].reads;
    losses += facts.servo[i].losses;
    if (facts.servo[i].losses > facts.servo[worst_servo].losses) worst_servo = i;
  }
  if (reads == 0) return;
  const double rate = static_cast<double>(losses) / reads;
  const std::string what = format("%d of %d single reads were lost (%.1f %%)", losses, reads, 100 * rate);
  if (losses < 2 || rate <= kLossAlarm) {
    rows.push_back({Level::kOk, what, {}});
    return;
  }
  rows.push_back({rate > kLossFatal ? Level::kError : Level::kWarning, what,
                  "most at " + servoName(static_cast<Joint>(worst_servo)) +
                      ": look for a worn cable or a loose plug on the way to it, and for a weak supply when losses "
                      "grow along a chain"});
}

}  // namespace

Nanos cycleTime(const RobotFacts& facts) {
  return wireTime(cycleBytes()) + returnDelays(facts) + 2 * usbTime(facts);
}

Findings diagnose(const RobotFacts& facts) {
  Findings rows;
  if (facts.lost) {
    rows.push_back({Level::kError, facts.port + " went away while the robot was looked at",
                    "check the USB cable, and whether the robot's power is stable"});
    return rows;
  }
  addBoard(facts, rows);
  if (!facts.board.readable) return rows;
  addRoundTrip(facts, rows);
  if (!facts.board.power_on) return rows;
  addServoRows(facts, rows);
  addCycle(facts, rows);
  addLosses(facts, rows);
  return rows;
}

}  // namespace darwinop::cm730
