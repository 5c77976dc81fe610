// Findings about the board and the supply.
#include "hal/cm730/diagnosis/board_rows.hpp"

#include <algorithm>
#include <vector>

#include "core/board_models.hpp"
#include "core/registers.hpp"
#include "core/servo_limits.hpp"
#include "hal/cm730/diagnosis/diagnosis.hpp"
#include "hal/cm730/diagnosis/row_text.hpp"

namespace darwinop::cm730 {
namespace {

constexpr std::uint16_t kCm730Model = find(kCm730, "model").reset;

constexpr const char* kHowToPermitNoBoard =
    "connect the servos to a CM-730 or CM-740; if they are alone on purpose, permit it in robot.ini: [Robot] board = "
    "none (no buttons, no inertial sensor, servo power unknown: docs/robot-file.md)";

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
        kHowToPermitNoBoard);
  return Finding::of(Kind::kBoardSilent, "no CM-730 answers on " + facts.port,
                     "switch the robot on and check the USB cable inside it; the board's LEDs must be lit");
}

/// Median of the servos' readings; unknown: none answers.
Volt servosVoltage(const RobotFacts& facts) {
  std::vector<double> volts;
  for (const ServoFacts& servo : facts.servo)
    if (servo.readable) volts.push_back(servo.voltage.value);
  if (volts.empty()) return {};
  std::ranges::sort(volts);
  return Volt{volts[volts.size() / 2]};
}

Finding supply(Volt voltage) {
  const std::string volts = format("supply %.1f V", voltage.value);
  if (voltage.value < kBatteryEmptyV)
    return Finding::of(Kind::kSupplyEmpty, volts + ": empty", "change the battery or plug in the power supply");
  if (voltage.value < kBatteryLowV)
    return Finding::of(Kind::kSupplyLow, volts + ": low", "charge or change the battery soon");
  return Finding::ok(volts);
}

/// Servo power is not read: only the servos' replies show that it is on.
void addNoBoard(const RobotFacts& facts, Findings& rows) {
  rows.push_back(
      Finding::ok("no board, as robot.ini says: no buttons, LEDs, inertial sensor; servo power is unknown, and nothing "
                  "switches it"));
  if (const Volt volts = servosVoltage(facts); volts.known()) rows.push_back(supply(volts));
}

}  // namespace

void addBoardRows(const RobotFacts& facts, Findings& rows) {
  const BoardFacts& board = facts.board;
  if (board.absent) return addNoBoard(facts, rows);
  if (!board.readable) {
    rows.push_back(silentBoard(facts));
    return;
  }
  const BoardModel* const model = findBoardModel(board.model);
  if (facts.permitted.no_board) {
    rows.push_back(Finding::of(Kind::kBoardNotExpected,
                               boardName(board) + " answers on " + facts.port + ", but robot.ini says board = none",
                               "remove [Robot] board = none from robot.ini"));
    return;
  }
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
  rows.push_back(supply(board.voltage));
  if (!isSupported(facts)) return;
  if (!board.power_on)
    rows.push_back(Finding::of(Kind::kServoPowerOff, "cannot switch servo power on",
                               "check battery and power switch, press the board's RESET button and try again"));
  else
    rows.push_back(Finding::ok(board.power_was_on ? "servo power is on" : "servo power was off; switched on"));
}

}  // namespace darwinop::cm730
