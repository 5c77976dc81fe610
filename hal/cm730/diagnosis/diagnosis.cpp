// Findings about the board, the serial line and the cycle time. Servos: servo_rows.cpp.
#include "hal/cm730/diagnosis/diagnosis.hpp"

#include <algorithm>
#include <cstdio>

#include "core/board_models.hpp"
#include "core/registers.hpp"
#include "core/servo_limits.hpp"
#include "hal/cm730/diagnosis/cycle_time.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"
#include "hal/cm730/usb_serial.hpp"

namespace darwinop::cm730 {
namespace {

constexpr std::uint16_t kCm730Model = find(kCm730, "model").reset;

template <class... Args>
std::string format(const char* pattern, Args... args) {
  char text[200];
  std::snprintf(text, sizeof text, pattern, args...);
  return text;
}

double ms(Nanos time) {
  return static_cast<double>(time.count()) * 1e-6;
}

Finding silentBoard(const RobotFacts& facts) {
  if (facts.board.garbled)
    return Finding::of(Kind::kBoardGarbled, "the data from " + facts.port + " are not CM-730 replies",
                       "check that this is the robot's port, that no other program uses it, and the USB cable");
  if (facts.board.found)
    return Finding::of(Kind::kBoardUnreadable, "cannot read the registers of the CM-730 on " + facts.port,
                       "press the board's RESET button and try again; then check the USB cable");
  if (facts.board.servos_without_it > 0)
    return Finding::of(
        Kind::kNoBoard,
        format("no board answers on %s, but servos do (%d): a USB2Dynamixel or U2D2, or a board whose id "
               "is not %d",
               facts.port.c_str(), facts.board.servos_without_it, int{kBoardId}),
        "connect the servos to a CM-730 or CM-740; servos without a board are not driven");
  return Finding::of(Kind::kBoardSilent, "no CM-730 answers on " + facts.port,
                     "switch the robot on and check the USB cable inside it; the board's LEDs must be lit");
}

Finding supply(const BoardFacts& board) {
  const std::string volts = format("supply %.1f V", board.voltage.value);
  if (board.voltage.value < kBatteryEmptyV)
    return Finding::of(Kind::kSupplyEmpty, volts + ": empty", "change the battery or plug in the power supply");
  if (board.voltage.value < kBatteryLowV)
    return Finding::of(Kind::kSupplyLow, volts + ": low", "charge or change the battery soon");
  return Finding::ok(volts);
}

void addBoard(const RobotFacts& facts, Findings& rows) {
  const BoardFacts& board = facts.board;
  if (!board.readable) {
    rows.push_back(silentBoard(facts));
    return;
  }
  const BoardModel* const model = findBoardModel(board.model);
  rows.push_back(Finding::ok(format("%s found, firmware 0x%02X", boardName(board).c_str(), board.firmware)));
  if (model != nullptr && !model->unconfirmed.empty())
    rows.back().what.append("; not confirmed on hardware: ").append(model->unconfirmed);
  if (!isSupported(facts))
    rows.push_back(Finding::of(
        Kind::kBoardModel,
        format("unsupported board model %d (expected %d, CM-730): its registers may differ, and nothing is written",
               board.model, kCm730Model),
        format("if its registers are those of a CM-730, permit it in robot.ini: [Robot] board_model = %d",
               board.model)));
  else if (model == nullptr)
    rows.push_back(Finding::ok(format("board model %d is permitted by robot.ini", board.model)));
  rows.push_back(supply(board));
  if (!isSupported(facts)) return;
  if (!board.power_on)
    rows.push_back(Finding::of(Kind::kServoPowerOff, "cannot switch servo power on",
                               "check battery and power switch, press the board's RESET button and try again"));
  else
    rows.push_back(Finding::ok(board.power_was_on ? "servo power is on" : "servo power was off; switched on"));
}

void addRoundTrip(const RobotFacts& facts, Findings& rows) {
  if (facts.round_trip_reads == 0) {
    rows.push_back(Finding::of(Kind::kLineNoisy,
                               "all short reads failed at the first attempt: the line is too noisy to measure",
                               "check the USB cable and both connectors"));
    return;
  }
  const std::string what =
      format("a short read takes %.2f ms (median of %d)", ms(facts.round_trip), facts.round_trip_reads);
  if (facts.round_trip < kLatencySignature)
    rows.push_back(Finding::ok(what));
  else
    rows.push_back(Finding::of(Kind::kRoundTripLong, what + ": the FTDI chip of the port delays data",
                               latencyCommand(facts.port) + "   (permanently: udev rule in docs/doctor.md)"));
}

void addCycle(const RobotFacts& facts, Findings& rows) {
  const Nanos delays = returnDelays(facts), usb = usbTime(facts);
  const std::string what =
      format("a full cycle takes %.1f ms of %.0f: %.2f on the wire, %.1f of return delays, %.1f of USB",
             ms(cycleTime(facts)), ms(facts.period), ms(cycleWireTime()), ms(delays), ms(usb));
  if (cycleFits(facts))
    rows.push_back(Finding::ok(what));
  else if (delays > usb)
    rows.push_back(Finding::of(Kind::kCycleTooLong, what + ": too long",
                               "set the return delays to 0: `darwinop doctor --fix` while torque is off"));
  else
    rows.push_back(Finding::of(Kind::kCycleTooLong, what + ": too long",
                               "choose a longer period, or: " + latencyCommand(facts.port)));
}

constexpr const char* kUpdateBoard = "update the CM-730 firmware with the vendor's tool";

void addInstructions(const RobotFacts& facts, Findings& rows) {
  const InstructionFacts& tried = facts.instructions;
  if (!tried.tried) return;
  if (!tried.bulk_read) {
    rows.push_back(Finding::of(
        Kind::kNoBulkRead, format("the board supports READ but not BULK_READ (firmware 0x%02X)", facts.board.firmware),
        kUpdateBoard));
    return;
  }
  if (!tried.sync_write)
    rows.push_back(
        Finding::of(Kind::kNoSyncWrite,
                    format("servos execute WRITE but not SYNC_WRITE: board firmware 0x%02X does not forward it",
                           facts.board.firmware),
                    kUpdateBoard));
  else if (!tried.all_blocks)
    rows.push_back(Finding::of(Kind::kBlockLengths,
                               "the board answers BULK_READ for 30 of its registers but not for every length up to "
                               "57; 30 are read in every cycle, and late replies are not detected",
                               kUpdateBoard));
  else
    rows.push_back(Finding::ok("BULK_READ and SYNC_WRITE work"));
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
    rows.push_back(Finding::ok(what));
    return;
  }
  rows.push_back(Finding::of(Kind::kRepliesLost, what,
                             "most at " + servoName(static_cast<Joint>(worst_servo)) +
                                 ": check cable and connectors towards it; if losses grow along a chain, check the "
                                 "supply"));
}

}  // namespace

std::string boardName(const BoardFacts& board) {
  const BoardModel* const model = findBoardModel(board.model);
  return model != nullptr ? std::string{model->name} : "board of model " + std::to_string(board.model);
}

bool isSupported(const ServoFacts& servo, const Permitted& permitted) {
  const ServoModel* const model = findServoModel(servo.model);
  return servo.readable && model != nullptr && isDriven(*model, permitted.servo_models) &&
         servo.firmware >= model->oldest_firmware;
}

bool isSupported(const RobotFacts& facts) {
  return findBoardModel(facts.board.model) != nullptr || facts.board.model == facts.permitted.board_model;
}

Findings diagnose(const RobotFacts& facts) {
  Findings rows;
  if (facts.lost) {
    rows.push_back(Finding::of(Kind::kPortLost, facts.port + " was lost during the check",
                               "check the USB cable and the robot's power supply"));
    return rows;
  }
  addBoard(facts, rows);
  if (!facts.board.readable) return rows;
  addRoundTrip(facts, rows);
  if (!isSupported(facts) || !facts.board.power_on) return rows;
  addServoRows(facts, rows);
  addCycle(facts, rows);
  addInstructions(facts, rows);
  addLosses(facts, rows);
  return rows;
}

}  // namespace darwinop::cm730
