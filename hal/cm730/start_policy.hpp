// Start-up policy for each kind of finding; used by the doctor's marks and by the start of a loop.
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace darwinop::cm730 {

/// In ascending severity.
enum class Policy : std::uint8_t {
  kDrive,     // with a warning
  kLeaveOut,  // drive without that joint, with a warning
  kRest,      // start the loop, since the robot may be under torque; the safety layer sits it down
  kWait,      // do not start; may resolve by itself, so `darwinop runtime --wait` retries
  kRefuse,    // do not start; needs user action
};
// In the order of the enumerators.
inline constexpr std::array<std::string_view, 5> kPolicyNames{"drive, with a warning", "drive without that joint",
                                                              "start, and sit down", "wait for it", "refuse"};

/// Purpose of a start.
enum class Purpose : std::uint8_t {
  kDrive,
  kRescue,  // the supervisor brings the robot to rest after a runtime failure: it may be under torque, and no other
            // program can
};

enum class Kind : std::uint8_t {
  kRobotFile,
  kPortMissing,
  kPortUnusable,
  kPortLost,
  kLatencyTimer,
  kClockCoarse,
  kPriority,
  kMemory,
  kBoardSilent,
  kBoardGarbled,
  kBoardUnreadable,
  kBoardModel,
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
  kStartPose,
  kCount,
};
inline constexpr std::size_t kKinds = static_cast<std::size_t>(Kind::kCount);

struct KindRow {
  Kind kind;
  Policy drive, rescue;  // by purpose
  std::string_view finding, reason;
};

// docs/doctor.md contains this table; a test compares them.
inline constexpr auto kKindTable = std::to_array<KindRow>({
    {Kind::kRobotFile, Policy::kRefuse, Policy::kRefuse, "a mistake in robot.ini",
     "invalid limits would not be applied"},
    {Kind::kPortMissing, Policy::kWait, Policy::kWait, "the port is missing or in use", "USB comes late at boot"},
    {Kind::kPortUnusable, Policy::kRefuse, Policy::kRefuse, "the port cannot be used",
     "permissions and wrong paths need user action"},
    {Kind::kPortLost, Policy::kWait, Policy::kWait, "the port was lost during the check", "it may come back"},
    {Kind::kLatencyTimer, Policy::kDrive, Policy::kDrive, "the FTDI latency timer is above 1 ms",
     "the measured cycle time decides"},
    {Kind::kClockCoarse, Policy::kRefuse, Policy::kDrive, "clock resolution of milliseconds",
     "cycles would be late by a large part of a period"},
    {Kind::kPriority, Policy::kDrive, Policy::kDrive, "real-time priority is refused",
     "late cycles hold the last goals; `--realtime required` refuses"},
    {Kind::kMemory, Policy::kDrive, Policy::kDrive, "locking memory is refused", "as for real-time priority"},
    {Kind::kBoardSilent, Policy::kWait, Policy::kWait, "no CM-730 answers", "the robot may be switched on later"},
    {Kind::kBoardGarbled, Policy::kRefuse, Policy::kRefuse, "invalid replies",
     "it may be another device; do not write to it"},
    {Kind::kBoardUnreadable, Policy::kRefuse, Policy::kRefuse, "the board's registers cannot be read",
     "supply and buttons could not be monitored"},
    {Kind::kBoardModel, Policy::kDrive, Policy::kDrive, "the board is another model",
     "its instructions are tested at every start"},
    {Kind::kSupplyLow, Policy::kDrive, Policy::kDrive, "the supply is under 11 V", "fault battery_low reports it"},
    {Kind::kSupplyEmpty, Policy::kRest, Policy::kRest, "the supply is under 10 V",
     "fault battery_empty sits the robot down after 2 s"},
    {Kind::kServoPowerOff, Policy::kRefuse, Policy::kRefuse, "servo power cannot be switched on",
     "no servo can be checked"},
    {Kind::kLineNoisy, Policy::kWait, Policy::kDrive, "no short read is answered at the first attempt",
     "the noise may be temporary"},
    {Kind::kRoundTripLong, Policy::kDrive, Policy::kDrive, "a short read takes 8 ms or more",
     "the measured cycle time decides"},
    {Kind::kCycleTooLong, Policy::kWait, Policy::kWait, "a cycle takes longer than the period allows",
     "the last servos would count as silent; at boot a busy computer measures too long"},
    {Kind::kRepliesLost, Policy::kDrive, Policy::kDrive, "more than 1 % of single reads are lost",
     "a joint without recent readings gets no goals"},
    {Kind::kNoBulkRead, Policy::kRefuse, Policy::kRefuse, "the board does not answer to BULK_READ",
     "the loop reads with BULK_READ only"},
    {Kind::kNoSyncWrite, Policy::kRefuse, Policy::kRefuse, "SYNC_WRITE has no effect",
     "the loop writes to servos with SYNC_WRITE only"},
    {Kind::kBlockLengths, Policy::kDrive, Policy::kDrive, "BULK_READ works with some block lengths only",
     "a fixed length is read; a late reply may then be taken for a new one"},
    {Kind::kServoInstruction, Policy::kRefuse, Policy::kLeaveOut, "a servo does not support BULK_READ or SYNC_WRITE",
     "its goals or its replies would be missing"},
    {Kind::kNoServo, Policy::kWait, Policy::kWait, "none of the servos answers", "a fuse or cable may be fixed later"},
    {Kind::kLegServoSilent, Policy::kWait, Policy::kLeaveOut, "a servo of a leg is silent",
     "a robot that stands on a limp joint falls; `absent` in robot.ini permits it"},
    {Kind::kServoSilent, Policy::kLeaveOut, Policy::kLeaveOut, "a servo of an arm or the head is silent",
     "the robot can stand, walk and sit without it; its mode is unknown, so it gets no goals before the next start"},
    {Kind::kServoGarbled, Policy::kRefuse, Policy::kLeaveOut, "a servo's replies are garbled",
     "two servos may share an id and both would move"},
    {Kind::kServoUnreadable, Policy::kRefuse, Policy::kLeaveOut, "a servo answers pings only",
     "its position is unknown"},
    {Kind::kServoModel, Policy::kRefuse, Policy::kLeaveOut, "unsupported servo model",
     "its registers and units may differ"},
    {Kind::kServoFirmware, Policy::kRefuse, Policy::kLeaveOut, "servo firmware older than 27",
     "1024 steps per turn: every goal would be a wrong angle"},
    {Kind::kWheelMode, Policy::kRefuse, Policy::kLeaveOut, "a servo in wheel mode",
     "the loop's speed limit would make it turn continuously"},
    {Kind::kMultiTurnMode, Policy::kRefuse, Policy::kLeaveOut, "a servo in multi-turn mode",
     "positions and goals have a different range and zero"},
    {Kind::kNoRange, Policy::kRefuse, Policy::kLeaveOut, "a servo's own limits exclude the whole joint range",
     "it would reject every goal"},
    {Kind::kStartPoseOutside, Policy::kRefuse, Policy::kDrive, "the start pose is outside a servo's own limits",
     "the robot could not sit down, which is the reaction to most faults"},
    {Kind::kNarrowRange, Policy::kDrive, Policy::kDrive, "a servo's own limits are narrower than the joint's",
     "the narrower limits apply to every goal"},
    {Kind::kMaxTorqueZero, Policy::kRefuse, Policy::kLeaveOut, "a servo's max torque (EEPROM) is 0",
     "it has no torque after each power-up"},
    {Kind::kTorqueLimitZero, Policy::kDrive, Policy::kDrive, "a servo's torque limit (RAM) is 0",
     "set by the servo or a program; written again at takeover"},
    {Kind::kReturnDelay, Policy::kDrive, Policy::kDrive, "a servo has a return delay",
     "the measured cycle time decides"},
    {Kind::kStatusLevel, Policy::kDrive, Policy::kDrive, "a servo's status return level is 1",
     "the loop does not need acknowledgements"},
    {Kind::kServoHot, Policy::kDrive, Policy::kDrive, "a servo is at 65 deg C or more",
     "fault servo_hot limits the speed of all joints"},
    {Kind::kServoTooHot, Policy::kRest, Policy::kRest, "a servo is at 75 deg C or more",
     "fault servo_overheat sits the robot down"},
    {Kind::kServoOverheatBit, Policy::kRest, Policy::kRest, "a servo's overheating bit is set",
     "fault servo_overheat sits the robot down"},
    {Kind::kServoOverloadBit, Policy::kDrive, Policy::kDrive, "a servo's overload bit is set",
     "cleared at takeover; if it stays, fault servo_overload sits the robot down"},
    {Kind::kServoErrorBit, Policy::kDrive, Policy::kDrive, "another error bit of a servo is set",
     "the safety layer monitors them"},
    {Kind::kStartPose, Policy::kDrive, Policy::kDrive, "the robot is not in its start pose",
     "it is moved there slowly"},
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

/// The most severe policy; kDrive without findings.
inline Policy policyOf(const Kinds& kinds, Purpose purpose) {
  Policy worst = Policy::kDrive;
  for (std::size_t i = 0; i < kKinds; ++i)
    if (kinds[i]) worst = std::max(worst, policyOf(static_cast<Kind>(i), purpose));
  return worst;
}

}  // namespace darwinop::cm730
