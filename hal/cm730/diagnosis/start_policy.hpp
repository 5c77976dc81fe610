// Start-up policy for each kind of finding; the doctor's severities use the same table.
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace darwinop::cm730 {

/// In the order of severity.
enum class Policy : std::uint8_t {
  kDrive,     // with a warning
  kLeaveOut,  // drive without that joint, with a warning
  kNoWrites,  // the same, and write nothing to it, not even torque off: not known to be an MX-28
  kRest,      // the loop starts, as the robot may be stiff; the safety layer sits it down
  kWait,      // do not start; may resolve without user action, so `darwinop runtime --wait` retries
  kRefuse,    // do not start; user action needed
};
// In the order of the enumerators.
inline constexpr std::array<std::string_view, 6> kPolicyNames{"warn",     "omit", "no writes",
                                                              "sit down", "wait", "refuse"};

/// Why a loop is started.
enum class Purpose : std::uint8_t {
  kDrive,
  kRescue,  // the supervisor brings the robot to rest after its runtime has failed; it may be stiff
};

enum class Kind : std::uint8_t {
  kRobotFile,
  kNoRobotFile,
  kPortMissing,
  kPortUnusable,
  kPortLost,
  kLatencyTimer,
  kClockCoarse,
  kPriority,
  kMemory,
  kGovernor,
  kBoardSilent,
  kNoBoard,
  kBoardGarbled,
  kBoardUnreadable,
  kBoardModel,
  kBoardNotExpected,
  kSupplyLow,
  kSupplyEmpty,
  kServoPowerOff,
  kLineNoisy,
  kRoundTripLong,
  kCycleTooLong,
  kRepliesLost,
  kNoBulkRead,
  kNoSyncWrite,
  kBlockLengths,
  kServoInstruction,
  kNoServo,
  kLegServoSilent,
  kServoSilent,
  kServoGarbled,
  kServoUnreadable,
  kServoModel,
  kServoFirmware,
  kServoMode,
  kWheelMode,
  kMultiTurnMode,
  kNoRange,
  kStartPoseOutside,
  kNarrowRange,
  kMaxTorqueZero,
  kTorqueLimitZero,
  kReturnDelay,
  kStatusLevel,
  kServoHot,
  kServoTooHot,
  kServoOverheatBit,
  kServoOverloadBit,
  kServoErrorBit,
  kUnderTorque,
  kStartPose,
  kCount,
};
inline constexpr std::size_t kKinds = static_cast<std::size_t>(Kind::kCount);

struct KindRow {
  Kind kind;
  Policy drive, rescue;  // by purpose
  std::string_view finding, reason;
};

// docs/doctor.md has this table; tests compare both, and the table with the thresholds in core/servo_limits.hpp and
// diagnosis.hpp.
inline constexpr auto kKindTable = std::to_array<KindRow>({
    {Kind::kRobotFile, Policy::kRefuse, Policy::kRefuse, "a mistake in robot.ini", "its limits would not apply"},
    {Kind::kNoRobotFile, Policy::kDrive, Policy::kDrive, "no robot.ini for a USB port",
     "limits and offsets of a stock robot apply"},
    {Kind::kPortMissing, Policy::kWait, Policy::kWait, "port missing or in use", "USB comes late at boot"},
    {Kind::kPortUnusable, Policy::kRefuse, Policy::kRefuse, "port cannot be used",
     "permissions and paths need a person"},
    {Kind::kPortLost, Policy::kWait, Policy::kWait, "port lost during the check", "it may come back"},
    {Kind::kLatencyTimer, Policy::kDrive, Policy::kDrive, "FTDI latency timer above 1 ms",
     "measured cycle length decides"},
    {Kind::kClockCoarse, Policy::kRefuse, Policy::kDrive, "clock ticks in milliseconds", "cycles would be late"},
    {Kind::kPriority, Policy::kDrive, Policy::kDrive, "real-time priority refused",
     "late cycles hold the last goals; `--realtime required` refuses"},
    {Kind::kMemory, Policy::kDrive, Policy::kDrive, "memory lock refused", "as for real-time priority"},
    {Kind::kGovernor, Policy::kDrive, Policy::kDrive, "processor slows down when idle",
     "late cycles hold the last goals"},
    {Kind::kBoardSilent, Policy::kWait, Policy::kWait, "no CM-730 answers", "it may be switched on later"},
    {Kind::kNoBoard, Policy::kWait, Policy::kWait, "servos answer, but no board",
     "no sensors, buttons, power switch: `board = none` in robot.ini permits it; noise looks the same once"},
    {Kind::kBoardGarbled, Policy::kRefuse, Policy::kRefuse, "bytes that are not answers",
     "perhaps another device; never write to it"},
    {Kind::kBoardUnreadable, Policy::kRefuse, Policy::kRefuse, "board registers unreadable",
     "supply and buttons would not be watched"},
    {Kind::kBoardModel, Policy::kRefuse, Policy::kRefuse, "another board model",
     "its registers may differ; `board_model` in robot.ini permits it"},
    {Kind::kBoardNotExpected, Policy::kRefuse, Policy::kRefuse, "a board answers despite `board = none`",
     "nothing would watch its buttons and servo power"},
    {Kind::kSupplyLow, Policy::kDrive, Policy::kDrive, "supply under 11 V", "fault battery_low"},
    {Kind::kSupplyEmpty, Policy::kRest, Policy::kRest, "supply under 10 V", "fault battery_empty after 2 s"},
    {Kind::kServoPowerOff, Policy::kRefuse, Policy::kRefuse, "servo power stays off", "no servo can be checked"},
    {Kind::kLineNoisy, Policy::kWait, Policy::kDrive, "no short read succeeds at first try", "the noise may pass"},
    {Kind::kRoundTripLong, Policy::kDrive, Policy::kDrive, "a short read takes 8 ms or more",
     "measured cycle length decides"},
    {Kind::kCycleTooLong, Policy::kWait, Policy::kWait, "a cycle exceeds the period",
     "last servos would count as silent; a computer busy at boot measures too long"},
    {Kind::kRepliesLost, Policy::kDrive, Policy::kDrive, "over 1 % of single reads lost",
     "a joint without recent readings gets no goals"},
    {Kind::kNoBulkRead, Policy::kRefuse, Policy::kRefuse, "no answer to BULK_READ", "the loop needs it"},
    {Kind::kNoSyncWrite, Policy::kRefuse, Policy::kRefuse, "SYNC_WRITE has no effect", "the loop needs it"},
    {Kind::kBlockLengths, Policy::kDrive, Policy::kDrive, "BULK_READ limited to some block lengths",
     "a fixed length is read; a late answer can pass for a new one"},
    {Kind::kServoInstruction, Policy::kRefuse, Policy::kLeaveOut, "a servo lacks BULK_READ or SYNC_WRITE",
     "goals or replies would be missing"},
    {Kind::kNoServo, Policy::kWait, Policy::kWait, "all servos silent", "fuse or cable, repaired later"},
    {Kind::kLegServoSilent, Policy::kWait, Policy::kNoWrites, "a leg servo is silent",
     "a robot standing on a limp joint falls; `absent` in robot.ini permits it"},
    {Kind::kServoSilent, Policy::kNoWrites, Policy::kNoWrites, "an arm or head servo is silent",
     "the robot can walk and sit; unchecked, so no goals until the next start"},
    {Kind::kServoGarbled, Policy::kRefuse, Policy::kNoWrites, "a servo's replies are garbled",
     "two servos may share an id, and both would obey"},
    {Kind::kServoUnreadable, Policy::kRefuse, Policy::kNoWrites, "a servo answers pings only (status return level 0)",
     "its model is unknown until `darwinop doctor --fix`"},
    {Kind::kServoModel, Policy::kRefuse, Policy::kNoWrites, "unsupported servo model",
     "registers, units or torque differ; `servo_models` in robot.ini permits MX-64 and MX-106"},
    {Kind::kServoFirmware, Policy::kRefuse, Policy::kLeaveOut, "servo firmware before 27",
     "1024 steps a turn: wrong angles"},
    {Kind::kServoMode, Policy::kRefuse, Policy::kLeaveOut, "servo in torque control, slave or reverse mode",
     "goals have no effect or the opposite one"},
    {Kind::kWheelMode, Policy::kRefuse, Policy::kLeaveOut, "servo in wheel mode",
     "a speed limit makes it rotate endlessly"},
    {Kind::kMultiTurnMode, Policy::kRefuse, Policy::kLeaveOut, "servo in multi-turn mode", "other range and zero"},
    {Kind::kNoRange, Policy::kRefuse, Policy::kLeaveOut, "servo limits exclude the joint's range",
     "it would refuse every goal"},
    {Kind::kStartPoseOutside, Policy::kRefuse, Policy::kDrive, "servo limits exclude the start pose",
     "the robot could not sit down after a fault"},
    {Kind::kNarrowRange, Policy::kDrive, Policy::kDrive, "servo limits narrower than the joint's",
     "the narrower ones apply"},
    {Kind::kMaxTorqueZero, Policy::kRefuse, Policy::kLeaveOut, "max torque (EEPROM) is 0",
     "no torque after each power-up"},
    {Kind::kTorqueLimitZero, Policy::kDrive, Policy::kDrive, "torque limit (RAM) is 0",
     "rewritten when the joint is taken over where it is"},
    {Kind::kReturnDelay, Policy::kDrive, Policy::kDrive, "servo return delay above 0", "measured cycle length decides"},
    {Kind::kStatusLevel, Policy::kDrive, Policy::kDrive, "status return level 1", "write replies are not needed"},
    {Kind::kServoHot, Policy::kDrive, Policy::kDrive, "servo at 65 deg C or more", "fault servo_hot: gentle speed"},
    {Kind::kServoTooHot, Policy::kRest, Policy::kRest, "servo at 75 deg C or more", "fault servo_overheat"},
    {Kind::kServoOverheatBit, Policy::kRest, Policy::kRest, "overheating bit set", "fault servo_overheat"},
    {Kind::kServoOverloadBit, Policy::kDrive, Policy::kDrive, "overload bit set",
     "ends with the takeover, else fault servo_overload"},
    {Kind::kServoErrorBit, Policy::kDrive, Policy::kDrive, "another error bit set", "watched by the safety layer"},
    {Kind::kUnderTorque, Policy::kDrive, Policy::kDrive, "servos under torque without a loop",
     "taken over where they are"},
    {Kind::kStartPose, Policy::kDrive, Policy::kDrive, "not in the start pose", "moved there slowly"},
});

constexpr bool kindTableIsSound() {
  for (std::size_t i = 0; i < kKindTable.size(); ++i)
    if (kKindTable[i].kind != static_cast<Kind>(i)) return false;
  // A rescue does at least as much as a start.
  return kKindTable.size() == kKinds &&
         std::ranges::all_of(kKindTable, [](const KindRow& row) { return row.rescue <= row.drive; });
}
static_assert(kindTableIsSound());

using Kinds = std::bitset<kKinds>;

constexpr Policy policyOf(Kind kind, Purpose purpose = Purpose::kDrive) {
  const KindRow& row = kKindTable[static_cast<std::size_t>(kind)];
  return purpose == Purpose::kDrive ? row.drive : row.rescue;
}

/// The most severe policy; kDrive if there is no finding.
inline Policy policyOf(const Kinds& kinds, Purpose purpose) {
  Policy worst = Policy::kDrive;
  for (std::size_t i = 0; i < kKinds; ++i)
    if (kinds[i]) worst = std::max(worst, policyOf(static_cast<Kind>(i), purpose));
  return worst;
}

}  // namespace darwinop::cm730
