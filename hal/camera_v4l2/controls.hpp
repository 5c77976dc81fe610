// Brightness, exposure and the like: which of them are written, and to what.
#pragma once

#include <cstdint>

#include "hal/camera_v4l2/camera.hpp"
#include "hal/camera_v4l2/negotiate.hpp"

namespace darwinop::v4l2 {

/// What a driver says about one control.
struct ControlRange {
  int least = 0, most = 0, drivers_default = 0, now = 0;
};

struct ControlDecision {
  enum class What : std::uint8_t { kLeave, kWrite, kOutOfRange } what = What::kLeave;
  int value = 0;
};

/// A control is written only when it differs and the driver's range allows it; CameraSettings::kDriversDefault asks
/// for the driver's default.
[[nodiscard]] ControlDecision decide(int wanted, const ControlRange& range);

/// Automatic functions first: some cameras refuse a value while they choose it themselves. Controls that a camera
/// does not have are left out; what it does not allow is remarked upon. Never throws for the device's sake.
void applySettings(const Device& device, const CameraSettings& settings, const Remark& remark);

}  // namespace darwinop::v4l2
