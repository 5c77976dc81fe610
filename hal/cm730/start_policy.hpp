// What start-up does about each kind of finding. The doctor's marks and the start of a loop read the same table.
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
  kRest,      // the loop starts, as the robot may be stiff; the safety layer sits it down
  kWait,      // do not start; it may come by itself, so `darwinop runtime --wait` tries again
  kRefuse,    // do not start; somebody has to do something first
};
// In the order of the enumerators.
inline constexpr std::array<std::string_view, 5> kPolicyNames{"drive, with a warning", "drive without that joint",
                                                              "start, and sit down", "wait for it", "refuse"};

/// Why a loop is started.
enum class Purpose : std::uint8_t {
  kDrive,
  kRescue,  // the supervisor brings a robot to rest whose runtime has failed: it may be stiff, and nobody else is there
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

// docs/doctor.md has this table; a test compares them.
inline constexpr auto kKindTable = std::to_array<KindRow>({
    {Kind::kRobotFile, Policy::kRefuse, Policy::kRefuse, "a mistake in robot.ini",
     "limits that are not understood do not limit"},
    {Kind::kPortMissing, Policy::kWait, Policy::kWait, "the port is not there, or in use", "USB comes late at boot"},
    {Kind::kPortUnusable, Policy::kRefuse, Policy::kRefuse, "the port cannot be used",
     "permissions and wrong paths do not change by themselves"},
    {Kind::kPortLost, Policy::kWait, Policy::kWait, "the port went away during the check", "it may come back"},
    {Kind::kLatencyTimer, Policy::kDrive, Policy::kDrive, "the FTDI latency timer is above 1 ms",
     "the measured length of a cycle decides"},
    {Kind::kClockCoarse, Policy::kRefuse, Policy::kDrive, "the clock ticks in milliseconds",
     "cycles would be late by a large share of a period"},
    {Kind::kPriority, Policy::kDrive, Policy::kDrive, "real-time priority is refused",
     "late cycles hold the last goals; `--realtime required` refuses"},
    {Kind::kMemory, Policy::kDrive, Policy::kDrive, "locking memory is refused", "as for real-time priority"},
    {Kind::kBoardSilent, Policy::kWait, Policy::kWait, "no CM-730 answers", "the robot may be switched on later"},
    {Kind::kBoardGarbled, Policy::kRefuse, Policy::kRefuse, "bytes that are not answers",
     "it may be another device, which must not be written to"},
    {Kind::kBoardUnreadable, Policy::kRefuse, Policy::kRefuse, "the board's registers cannot be read",
     "supply and buttons would not be watched"},
    {Kind::kBoardModel, Policy::kDrive, Policy::kDrive, "the board is another model",
     "its instructions are tried at every start"},
    {Kind::kSupplyLow, Policy::kDrive, Policy::kDrive, "the supply is under 11 V", "fault battery_low reports it"},
    {Kind::kSupplyEmpty, Policy::kRest, Policy::kRest, "the supply is under 10 V",
     "fault battery_empty sits the robot down after 2 s"},
    {Kind::kServoPowerOff, Policy::kRefuse, Policy::kRefuse, "servo power does not come on", "no servo can be checked"},
    {Kind::kLineNoisy, Policy::kWait, Policy::kDrive, "no short read is answered at the first try",
     "noise that drowns every read may pass"},
    {Kind::kRoundTripLong, Policy::kDrive, Policy::kDrive, "a short read takes 8 ms or more",
     "the measured length of a cycle decides"},
    {Kind::kCycleTooLong, Policy::kWait, Policy::kWait, "a cycle takes longer than the period allows",
     "the last servos would count as silent; a computer that is busy at boot measures too long, too"},
    {Kind::kRepliesLost, Policy::kDrive, Policy::kDrive, "more than 1 % of single reads are lost",
     "a joint without recent readings gets no goals"},
    {Kind::kNoBulkRead, Policy::kRefuse, Policy::kRefuse, "the board does not answer to BULK_READ",
     "the loop reads with nothing else"},
    {Kind::kNoSyncWrite, Policy::kRefuse, Policy::kRefuse, "SYNC_WRITE has no effect",
     "the loop writes to servos with nothing else"},
    {Kind::kBlockLengths, Policy::kDrive, Policy::kDrive, "BULK_READ works with some block lengths only",
     "a fixed length is read; a late answer can then pass for a new one"},
    {Kind::kServoInstruction, Policy::kRefuse, Policy::kLeaveOut, "a servo does not obey BULK_READ or SYNC_WRITE",
     "its goals or its replies would be missing"},
    {Kind::kNoServo, Policy::kWait, Policy::kWait, "none of the servos answers", "a fuse or a cable, put right later"},
    {Kind::kLegServoSilent, Policy::kWait, Policy::kLeaveOut, "a servo of a leg is silent",
     "a robot that stands on a limp joint falls; `absent` in robot.ini permits it"},
    {Kind::kServoSilent, Policy::kLeaveOut, Policy::kLeaveOut, "a servo of an arm or the head is silent",
     "the robot can stand, walk and sit without it; its mode is unknown, so it gets no goals before the next start"},
    {Kind::kServoGarbled, Policy::kRefuse, Policy::kLeaveOut, "a servo's replies are garbled",
     "two servos may share an id, and both would obey"},
    {Kind::kServoUnreadable, Policy::kRefuse, Policy::kLeaveOut, "a servo answers to pings only",
     "where it stands is unknown"},
    {Kind::kServoModel, Policy::kRefuse, Policy::kLeaveOut, "unsupported servo model",
     "its registers and units may be others"},
    {Kind::kServoFirmware, Policy::kRefuse, Policy::kLeaveOut, "servo firmware older than 27",
     "1024 steps a turn: every goal would be another angle"},
    {Kind::kWheelMode, Policy::kRefuse, Policy::kLeaveOut, "a servo in wheel mode",
     "the speed limit that the loop writes makes it turn without end"},
    {Kind::kMultiTurnMode, Policy::kRefuse, Policy::kLeaveOut, "a servo in multi-turn mode",
     "positions and goals have another range and zero"},
    {Kind::kNoRange, Policy::kRefuse, Policy::kLeaveOut, "a servo's own limits leave nothing of the joint's range",
     "it would refuse every goal"},
    {Kind::kStartPoseOutside, Policy::kRefuse, Policy::kDrive, "the start pose is outside of a servo's own limits",
     "the robot could not sit down, which is the reaction to most faults"},
    {Kind::kNarrowRange, Policy::kDrive, Policy::kDrive, "a servo's own limits are narrower than the joint's",
     "the narrower limits hold for every goal"},
    {Kind::kMaxTorqueZero, Policy::kRefuse, Policy::kLeaveOut, "a servo's max torque (EEPROM) is 0",
     "it comes up without torque each time its power is switched on"},
    {Kind::kTorqueLimitZero, Policy::kDrive, Policy::kDrive, "a servo's torque limit (RAM) is 0",
     "the servo or a program has set it; it is written again when the joint is taken over where it is"},
    {Kind::kReturnDelay, Policy::kDrive, Policy::kDrive, "a servo waits before it answers",
     "the measured length of a cycle decides"},
    {Kind::kStatusLevel, Policy::kDrive, Policy::kDrive, "a servo's status return level is 1",
     "the loop does not need answers to writes"},
    {Kind::kServoHot, Policy::kDrive, Policy::kDrive, "a servo is at 65 deg C or more",
     "fault servo_hot moves all joints gently"},
    {Kind::kServoTooHot, Policy::kRest, Policy::kRest, "a servo is at 75 deg C or more",
     "fault servo_overheat sits the robot down"},
    {Kind::kServoOverheatBit, Policy::kRest, Policy::kRest, "a servo's overheating bit is set",
     "fault servo_overheat sits the robot down"},
    {Kind::kServoOverloadBit, Policy::kDrive, Policy::kDrive, "a servo's overload bit is set",
     "it ends with the takeover; if it stays, fault servo_overload sits the robot down"},
    {Kind::kServoErrorBit, Policy::kDrive, Policy::kDrive, "another error bit of a servo is set",
     "the safety layer watches them"},
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

/// The most severe policy; kDrive when there is no finding.
inline Policy policyOf(const Kinds& kinds, Purpose purpose) {
  Policy worst = Policy::kDrive;
  for (std::size_t i = 0; i < kKinds; ++i)
    if (kinds[i]) worst = std::max(worst, policyOf(static_cast<Kind>(i), purpose));
  return worst;
}

}  // namespace darwinop::cm730
