// Names of virtual camera faults on the command line.
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

#include "hil-mocks/camera/frame_file.hpp"

namespace darwinop::hil {

struct CameraFaultRow {
  CameraFault fault;
  std::string_view name;
};

inline constexpr CameraFaultRow kCameraFaults[] = {
    {CameraFault::kNone, "none"},
    {CameraFault::kGone, "gone"},
    {CameraFault::kSilent, "silent"},
    {CameraFault::kShort, "short"},
    {CameraFault::kFlagged, "flagged"},
    {CameraFault::kIoError, "io-error"},
    {CameraFault::kSlow, "slow"},
    {CameraFault::kBusy, "busy"},
    {CameraFault::kNoAccess, "no-access"},
    {CameraFault::kOtherFormat, "other-format"},
    {CameraFault::kOneBuffer, "one-buffer"},
    {CameraFault::kNoMmap, "no-mmap"},
    {CameraFault::kDrops, "drops"},
};

constexpr std::optional<CameraFault> cameraFault(std::string_view name) {
  const auto* const row = std::ranges::find(kCameraFaults, name, &CameraFaultRow::name);
  return row == std::ranges::end(kCameraFaults) ? std::nullopt : std::optional{row->fault};
}

}  // namespace darwinop::hil
