// Camera controls (brightness, exposure, ...): which are written, and to what value.
#pragma once

#include <cstdint>

#include "hal/camera_v4l2/camera.hpp"
#include "hal/camera_v4l2/negotiate.hpp"

namespace darwinop::v4l2 {

/// Range and value of one control, from the driver.
struct ControlRange {
  int least = 0, most = 0, drivers_default = 0, now = 0;
};

struct ControlDecision {
  enum class What : std::uint8_t { kLeave, kWrite, kOutOfRange } what = What::kLeave;
  int value = 0;
};

/// A control is written only if it differs and is within the driver's range; CameraSettings::kDriversDefault selects
/// the driver's default.
[[nodiscard]] ControlDecision decide(int wanted, const ControlRange& range);

/// Automatic modes first: some cameras reject a value while they are automatic. Skips controls that the camera does not
/// have; reports rejected ones through `remark`. Never throws because of the device.
void applySettings(const V4l2Device& device, const CameraSettings& settings, const Remark& remark);

}  // namespace darwinop::v4l2
