// The faults that the doctor names, in the order in which it names them: a cause before its consequences.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace darwinop::cm730 {

enum class BusFault : std::uint8_t {
  kPortMissing,
  kPortUnusable,
  kPortLost,
  kOtherProgram,
  kBoardSilent,
  kNoBoard,
  kNotABoard,
  kBoardUnreadable,
  kBoardModel,
  kBoardNotExpected,
  kBrownOut,
  kSupplyLow,
  kBoardResets,
  kServoPowerOff,
  kLatencyTimer,
  kUsbDelays,
  kLooseConnector,
  kNoisyLine,
  kNoServo,
  kChainBroken,
  kDuplicateId,
  kWrongId,
  kServoSilent,
  kNoBulkRead,
  kNoSyncWrite,
  kBlockLengths,
  kStatusLevel,
  kServoModel,
  kServoFirmware,
  kServoMode,
  kWheelMode,
  kMultiTurnMode,
  kServoLimits,
  kMaxTorqueZero,
  kReturnDelays,
  kSwapped,
  kServoOverload,
  kServoHot,
  kServoErrorBit,
  kServoInstruction,
  kFirstReadLost,
  kCycleTooLong,
  kCount,
};
inline constexpr std::size_t kBusFaults = static_cast<std::size_t>(BusFault::kCount);

struct BusFaultRow {
  BusFault fault;
  std::string_view name;  // in JSON
  // PORT, SERVO, OTHER and FROM stand for a port, a servo or several, another servo or id, and the last device in
  // front of a break.
  std::string_view what, remedy;
  std::string_view shown;  // how the virtual robot shows it to the blind test; empty: not tried there
};

// Printed in docs/doctor.md. The blind test draws from it and holds the doctor against it.
inline constexpr auto kBusFaultTable = std::to_array<BusFaultRow>({
    {BusFault::kPortMissing, "port_missing", "PORT is missing", "plug in the USB cable and switch the robot on", ""},
    {BusFault::kPortUnusable, "port_unusable", "PORT cannot be used", "see the line under port", ""},
    {BusFault::kPortLost, "port_lost", "PORT was lost during the check",
     "replace the USB cable; check the robot's power supply", "port lost in the first second"},
    {BusFault::kOtherProgram, "other_program", "another program uses PORT",
     "stop it; `sudo fuser -v PORT` lists the programs", "polls every 8 to 100 ms and takes half of the replies"},
    {BusFault::kBoardSilent, "board_silent", "no CM-730 answers on PORT",
     "switch the robot on; check the USB cable inside it; is this the robot's port?", "no reply"},
    {BusFault::kNoBoard, "no_board", "servos answer on PORT, but no CM-730",
     "connect them to a CM-730 or CM-740, or set the board's id to 200; servos on a USB2Dynamixel or U2D2 are driven "
     "with [Robot] board = none in robot.ini",
     "servos alone"},
    {BusFault::kNotABoard, "not_a_board", "what arrives on PORT are not replies of a CM-730",
     "choose the robot's port; if it is, replace the USB cable", ""},
    {BusFault::kBoardUnreadable, "board_unreadable", "the CM-730 answers pings only",
     "press RESET; set its status return level to 2 with the vendor's tool", ""},
    {BusFault::kBoardModel, "board_model", "the board is another model",
     "permit it in robot.ini ([Robot] board_model) if its registers are those of a CM-730", "another model number"},
    {BusFault::kBoardNotExpected, "board_not_expected", "a board answers on PORT, but robot.ini says board = none",
     "remove [Robot] board = none from robot.ini", ""},
    {BusFault::kBrownOut, "brown_out", "the supply drops under load",
     "charge or replace the battery; check its plug and the cable to the board",
     "supply drops with the load: under 11 V, or until servos restart"},
    {BusFault::kSupplyLow, "supply_low", "the supply is low without load", "charge the battery or plug in the supply",
     "supply of 8 to 10.9 V"},
    {BusFault::kBoardResets, "board_resets", "the board restarts, and servo power goes off with it",
     "check the battery's plug, the power switch and the RESET button; then replace the board",
     "RESET every 0.15 to 0.9 s"},
    {BusFault::kServoPowerOff, "servo_power_off", "servo power stays off",
     "check battery and power switch, press RESET", ""},
    {BusFault::kLatencyTimer, "latency_timer", "the FTDI latency timer of PORT delays every reply",
     "set it to 1 ms: udev rule below", "timer of the bridge at 8 or 16 ms"},
    {BusFault::kUsbDelays, "usb_delays", "USB delays replies on PORT by several ms",
     "plug the robot into a port of the computer, without a hub; stop other load of computer and USB",
     "replies delayed by 2 ms to 5 to 8 ms"},
    {BusFault::kLooseConnector, "loose_connector", "a connector between FROM and SERVO is loose",
     "press and replace the cable from FROM into SERVO", "a chain's end unplugged for 20 to 80 ms at a time"},
    {BusFault::kNoisyLine, "noisy_line", "bytes are damaged all over the bus",
     "replace the USB cable, then the cables from the board; lay them away from motors; check the ground",
     "a bit of one byte in 500 to 1000 inverted"},
    {BusFault::kNoServo, "no_servo", "no servo answers although servo power is on",
     "check the board's servo fuse and the cables from the board", "all servos missing"},
    {BusFault::kChainBroken, "chain_broken", "the chain is broken between FROM and SERVO",
     "replace the cable from FROM into SERVO", "two or more servos up to a chain's end missing"},
    {BusFault::kDuplicateId, "duplicate_id", "two servos have the id of SERVO",
     "connect OTHER alone and set its id with the vendor's tool", "a servo has another's id"},
    {BusFault::kWrongId, "wrong_id", "SERVO has the id OTHER", "connect it alone and set its id with the vendor's tool",
     "a servo with id 21 to 110"},
    {BusFault::kServoSilent, "servo_silent", "SERVO is silent: defective, unplugged, or at another baud rate",
     "replace its cable; connect it alone and search all ids and baud rates with the vendor's tool (a new servo: id "
     "1, 57142 baud); not found: replace it",
     "a servo missing, or its register 4 not 1"},
    {BusFault::kNoBulkRead, "no_bulk_read", "the board does not support BULK_READ", "update the board's firmware",
     "no reply to it"},
    {BusFault::kNoSyncWrite, "no_sync_write", "the board does not forward SYNC_WRITE", "update the board's firmware",
     "without effect"},
    {BusFault::kBlockLengths, "block_lengths", "the board supports BULK_READ for some lengths only",
     "update the board's firmware", "BULK_READ of 30 board bytes only"},
    {BusFault::kStatusLevel, "status_level", "wrong status return level: SERVO", "`darwinop doctor --fix` while limp",
     "register 16 of a servo 0 or 1"},
    {BusFault::kServoModel, "servo_model", "not an MX-28: SERVO",
     "replace it by an MX-28; robot.ini can permit an MX-64 or MX-106 ([Robot] servo_models)",
     "a servo with model 12, 30, 310 or 320, not permitted"},
    {BusFault::kServoFirmware, "servo_firmware", "firmware before 27: SERVO", "update it with the vendor's tool",
     "firmware 10 to 26"},
    {BusFault::kServoMode, "servo_mode", "in torque control, slave or reverse mode: SERVO",
     "switch servo power off and on; then set register 10 to 0 with the vendor's tool if it is not", ""},
    {BusFault::kWheelMode, "wheel_mode", "in wheel mode: SERVO",
     "set registers 6 and 8 to 0 and 4095 with the vendor's tool", "both angle limits 0"},
    {BusFault::kMultiTurnMode, "multi_turn_mode", "in multi-turn mode: SERVO",
     "set registers 6 and 8 to 0 and 4095 with the vendor's tool", "both angle limits 4095"},
    {BusFault::kServoLimits, "servo_limits", "angle limits narrower than the joint's range: SERVO",
     "set registers 6 and 8 to 0 and 4095 with the vendor's tool", "an angle limit inside the joint's range"},
    {BusFault::kMaxTorqueZero, "max_torque_zero", "max torque is 0: SERVO",
     "set register 14 to 1023 with the vendor's tool", "register 14 is 0"},
    {BusFault::kReturnDelays, "return_delays", "return delay above 0: SERVO", "`darwinop doctor --fix` while limp",
     "250 in ten servos"},
    {BusFault::kSwapped, "swapped", "SERVO and OTHER are exchanged: the servos, or their ids",
     "move each by hand to see which is which; exchange their ids with the vendor's tool",
     "two ids exchanged, start pose"},
    {BusFault::kServoOverload, "servo_overload", "shut down by overload: SERVO",
     "free the joint, switch servo power off and on", "error bit set"},
    {BusFault::kServoHot, "servo_hot", "hot: SERVO", "let it cool down; check whether the joint pushes against a stop",
     "66 to 79 deg C"},
    {BusFault::kServoErrorBit, "servo_error_bit", "an error bit is set: SERVO", "see its line", ""},
    {BusFault::kServoInstruction, "servo_instruction", "lacks BULK_READ or SYNC_WRITE: SERVO",
     "update its firmware; replace its cable", ""},
    {BusFault::kFirstReadLost, "first_read_lost", "only the first read was lost",
     "none: the runtime repeats it; a program that ends on one lost read must be repaired",
     "first reply or first BULK_READ dropped"},
    {BusFault::kCycleTooLong, "cycle_too_long", "a cycle does not fit the period", "choose a longer period", ""},
});

constexpr bool busFaultTableIsSound() {
  for (std::size_t i = 0; i < kBusFaultTable.size(); ++i)
    if (kBusFaultTable[i].fault != static_cast<BusFault>(i)) return false;
  return kBusFaultTable.size() == kBusFaults;
}
static_assert(busFaultTableIsSound());

constexpr const BusFaultRow& row(BusFault fault) {
  return kBusFaultTable[static_cast<std::size_t>(fault)];
}

}  // namespace darwinop::cm730
