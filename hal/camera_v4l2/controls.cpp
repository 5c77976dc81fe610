// Writes a camera's controls (ref: "Camera device on the robot", write rule).
#include "hal/camera_v4l2/controls.hpp"

#include <linux/videodev2.h>

#include <array>
#include <cstring>

namespace darwinop::v4l2 {
namespace {

struct ControlRow {
  std::uint32_t id;
  const char* name;
  int wanted;
};

/// UVC cameras offer aperture priority (they have no aperture), others fully automatic exposure.
int automaticExposure(const V4l2Device& device) {
  for (const int mode : {V4L2_EXPOSURE_APERTURE_PRIORITY, V4L2_EXPOSURE_AUTO}) {
    v4l2_querymenu item{};
    item.id = V4L2_CID_EXPOSURE_AUTO;
    item.index = static_cast<std::uint32_t>(mode);
    if (request(device.fd(), VIDIOC_QUERYMENU, item) == 0) return mode;
  }
  return V4L2_EXPOSURE_APERTURE_PRIORITY;
}

void apply(const V4l2Device& device, const ControlRow& row, const Remark& remark) {
  v4l2_queryctrl about{};
  about.id = row.id;
  constexpr std::uint32_t kNotOurs = V4L2_CTRL_FLAG_DISABLED | V4L2_CTRL_FLAG_READ_ONLY | V4L2_CTRL_FLAG_GRABBED;
  if (request(device.fd(), VIDIOC_QUERYCTRL, about) != 0 || (about.flags & kNotOurs) != 0) return;
  v4l2_control control{};
  control.id = row.id;
  if (request(device.fd(), VIDIOC_G_CTRL, control) != 0) return;

  const ControlDecision decision =
      decide(row.wanted, {about.minimum, about.maximum, about.default_value, control.value});
  using What = ControlDecision::What;
  if (decision.what == What::kLeave) return;
  const std::string setting = device.path() + ": " + row.name + " " + std::to_string(decision.value);
  if (decision.what == What::kOutOfRange) {
    remark(setting + " is not written, this camera takes " + std::to_string(about.minimum) + " to " +
           std::to_string(about.maximum));
    return;
  }
  control.value = decision.value;
  if (const int error = request(device.fd(), VIDIOC_S_CTRL, control); error != 0)
    remark(setting + " is refused by the camera (" + std::strerror(error) + ")");
}

}  // namespace

ControlDecision decide(int wanted, const ControlRange& range) {
  using What = ControlDecision::What;
  const int value = wanted == CameraSettings::kDriversDefault ? range.drivers_default : wanted;
  if (value == range.now) return {What::kLeave, value};
  if (value < range.least || value > range.most) return {What::kOutOfRange, value};
  return {What::kWrite, value};
}

void applySettings(const V4l2Device& device, const CameraSettings& settings, const Remark& remark) {
  const int exposure_mode = settings.auto_exposure ? automaticExposure(device) : V4L2_EXPOSURE_MANUAL;
  const auto rows = std::to_array<ControlRow>({
      {V4L2_CID_EXPOSURE_AUTO, "exposure mode", exposure_mode},
      {V4L2_CID_AUTO_WHITE_BALANCE, "automatic white balance", settings.auto_white_balance ? 1 : 0},
      {V4L2_CID_AUTOGAIN, "automatic gain", settings.auto_gain ? 1 : 0},
      {V4L2_CID_HUE_AUTO, "automatic hue", settings.auto_hue ? 1 : 0},
      {V4L2_CID_BRIGHTNESS, "brightness", settings.brightness},
      {V4L2_CID_CONTRAST, "contrast", settings.contrast},
      {V4L2_CID_SATURATION, "saturation", settings.saturation},
      {V4L2_CID_GAIN, "gain", settings.gain},
      {V4L2_CID_EXPOSURE_ABSOLUTE, "exposure", settings.exposure},
  });
  for (const ControlRow& row : rows) {
    // Controls in automatic mode are not written.
    if (row.id == V4L2_CID_EXPOSURE_ABSOLUTE && settings.auto_exposure) continue;
    if (row.id == V4L2_CID_GAIN && settings.auto_gain) continue;
    apply(device, row, remark);
  }
}

}  // namespace darwinop::v4l2
