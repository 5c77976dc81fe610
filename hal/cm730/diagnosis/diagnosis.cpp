// Findings about the serial line and the cycle time. Board: board_rows.cpp; servos: servo_rows.cpp.
#include "hal/cm730/diagnosis/diagnosis.hpp"

#include <algorithm>

#include "core/board_models.hpp"
#include "core/registers.hpp"
#include "core/servo_limits.hpp"
#include "hal/cm730/diagnosis/board_rows.hpp"
#include "hal/cm730/diagnosis/cycle_time.hpp"
#include "hal/cm730/diagnosis/row_text.hpp"
#include "hal/cm730/diagnosis/servo_rows.hpp"
#include "hal/cm730/usb_serial.hpp"

namespace darwinop::cm730 {
namespace {

double ms(Nanos time) {
  return static_cast<double>(time.count()) * 1e-6;
}

void addRoundTrip(const RobotFacts& facts, Findings& rows) {
  const RoundTrip& measured = facts.round_trip;
  if (measured.reads == 0) {
    rows.push_back(Finding::of(Kind::kLineNoisy,
                               "all short reads failed at the first attempt: the line is too noisy to measure",
                               "check the USB cable and both connectors"));
    return;
  }
  const std::string what = format("a short read takes %.2f ms (median of %d)", ms(measured.median), measured.reads);
  if (measured.median < kLatencySignature)
    rows.push_back(Finding::ok(what));
  else if (!isTimer(measured))
    rows.push_back(Finding::of(Kind::kRoundTripLong,
                               format("%s and the shortest %.2f ms: the computer is busy or a USB hub delays data",
                                      what.c_str(), ms(measured.shortest)),
                               kDelayRemedy));
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
    rows.push_back(
        Finding::of(Kind::kCycleTooLong, what + ": too long",
                    "choose a longer period, or: " +
                        (isTimer(facts.round_trip) ? latencyCommand(facts.port) : std::string{kDelayRemedy})));
}

constexpr const char* kUpdateServos = "update the firmware of the servos with the vendor's tool";
constexpr const char* kUpdateBoard = "update the CM-730 firmware with the vendor's tool";

void addInstructions(const RobotFacts& facts, Findings& rows) {
  const InstructionFacts& tried = facts.instructions;
  if (!tried.tried) return;
  if (!tried.bulk_read) {
    rows.push_back(
        Finding::of(Kind::kNoBulkRead,
                    facts.board.absent
                        ? std::string{"the servos support READ but not BULK_READ"}
                        : format("the board supports READ but not BULK_READ (firmware 0x%02X)", facts.board.firmware),
                    facts.board.absent ? kUpdateServos : kUpdateBoard));
    return;
  }
  if (!tried.sync_write && facts.board.absent)
    rows.push_back(Finding::of(Kind::kNoSyncWrite, "servos execute WRITE but not SYNC_WRITE", kUpdateServos));
  else if (!tried.sync_write)
    rows.push_back(
        Finding::of(Kind::kNoSyncWrite,
                    format("servos execute WRITE but not SYNC_WRITE: board firmware 0x%02X does not forward it",
                           facts.board.firmware),
                    kUpdateBoard));
  else if (!tried.all_blocks && facts.board.absent)
    rows.push_back(Finding::of(Kind::kBlockLengths,
                               "a servo does not answer BULK_READ for every length of 21 to 44 registers; 21 are read "
                               "in every cycle, and late replies are not detected",
                               kUpdateServos));
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
  if (board.absent) return "no board";
  const BoardModel* const model = findBoardModel(board.model);
  return model != nullptr ? std::string{model->name} : "board of model " + std::to_string(board.model);
}

bool isSupported(const ServoFacts& servo, const Permitted& permitted) {
  const ServoModel* const model = findServoModel(servo.model);
  return servo.readable && model != nullptr && isDriven(*model, permitted.servo_models) &&
         servo.firmware >= model->oldest_firmware;
}

bool isSupported(const RobotFacts& facts) {
  if (facts.permitted.no_board) return facts.board.absent;
  return findBoardModel(facts.board.model) != nullptr || facts.board.model == facts.permitted.board_model;
}

Findings diagnose(const RobotFacts& facts) {
  Findings rows;
  if (facts.lost) {
    rows.push_back(Finding::of(Kind::kPortLost, facts.port + " was lost during the check",
                               "check the USB cable and the robot's power supply"));
    return rows;
  }
  addBoardRows(facts, rows);
  if (!facts.board.isKnown()) return rows;
  if (facts.board.absent && facts.board.servos_without_it == 0) {
    addServoRows(facts, rows);
    return rows;
  }
  addRoundTrip(facts, rows);
  if (!isSupported(facts) || !facts.board.suppliesServos()) return rows;
  addServoRows(facts, rows);
  addCycle(facts, rows);
  addInstructions(facts, rows);
  addLosses(facts, rows);
  return rows;
}

}  // namespace darwinop::cm730
