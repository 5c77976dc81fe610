// The faults that findings of one kind show by themselves. Those that several findings or measurements distinguish:
// fault_naming.cpp.
#pragma once

#include <array>

#include "hal/cm730/diagnosis/bus_faults.hpp"
#include "hal/cm730/diagnosis/start_policy.hpp"

namespace darwinop::cm730 {

struct KindFault {
  Kind kind;
  BusFault fault;
};
inline constexpr auto kKindFaults = std::to_array<KindFault>({
    {Kind::kBoardSilent, BusFault::kBoardSilent},
    {Kind::kNoBoard, BusFault::kNoBoard},
    {Kind::kBoardGarbled, BusFault::kNotABoard},
    {Kind::kBoardUnreadable, BusFault::kBoardUnreadable},
    {Kind::kBoardModel, BusFault::kBoardModel},
    {Kind::kBoardNotExpected, BusFault::kBoardNotExpected},
    {Kind::kServoPowerOff, BusFault::kServoPowerOff},
    {Kind::kNoBulkRead, BusFault::kNoBulkRead},
    {Kind::kNoSyncWrite, BusFault::kNoSyncWrite},
    {Kind::kBlockLengths, BusFault::kBlockLengths},
    {Kind::kServoUnreadable, BusFault::kStatusLevel},
    {Kind::kStatusLevel, BusFault::kStatusLevel},
    {Kind::kServoModel, BusFault::kServoModel},
    {Kind::kServoFirmware, BusFault::kServoFirmware},
    {Kind::kServoMode, BusFault::kServoMode},
    {Kind::kWheelMode, BusFault::kWheelMode},
    {Kind::kMultiTurnMode, BusFault::kMultiTurnMode},
    {Kind::kNoRange, BusFault::kServoLimits},
    {Kind::kStartPoseOutside, BusFault::kServoLimits},
    {Kind::kNarrowRange, BusFault::kServoLimits},
    {Kind::kMaxTorqueZero, BusFault::kMaxTorqueZero},
    {Kind::kReturnDelay, BusFault::kReturnDelays},
    {Kind::kTorqueLimitZero, BusFault::kServoOverload},
    {Kind::kServoOverloadBit, BusFault::kServoOverload},
    {Kind::kServoHot, BusFault::kServoHot},
    {Kind::kServoTooHot, BusFault::kServoHot},
    {Kind::kServoOverheatBit, BusFault::kServoHot},
    {Kind::kServoErrorBit, BusFault::kServoErrorBit},
    {Kind::kServoInstruction, BusFault::kServoInstruction},
});

}  // namespace darwinop::cm730
