// Camera controls: ranges and present values.
#pragma once

#include <linux/videodev2.h>

#include <cstdint>

namespace darwinop::hil::shim {

struct ControlRow {
  std::uint32_t id, type;
  const char* name;
  std::int32_t least, most, usual;
};

// Logitech C905 of the robot, as reported by the UVC driver; gain and hue as upstream's controller expects.
inline constexpr ControlRow kControls[] = {
    // Sorted by id, as V4L2_CTRL_FLAG_NEXT_CTRL requires.
    {V4L2_CID_USER_CLASS, V4L2_CTRL_TYPE_CTRL_CLASS, "User Controls", 0, 0, 0},
    {V4L2_CID_BRIGHTNESS, V4L2_CTRL_TYPE_INTEGER, "Brightness", 0, 255, 128},
    {V4L2_CID_CONTRAST, V4L2_CTRL_TYPE_INTEGER, "Contrast", 0, 255, 32},
    {V4L2_CID_SATURATION, V4L2_CTRL_TYPE_INTEGER, "Saturation", 0, 255, 28},
    {V4L2_CID_AUTO_WHITE_BALANCE, V4L2_CTRL_TYPE_BOOLEAN, "White Balance, Automatic", 0, 1, 1},
    {V4L2_CID_AUTOGAIN, V4L2_CTRL_TYPE_BOOLEAN, "Gain, Automatic", 0, 1, 1},
    {V4L2_CID_GAIN, V4L2_CTRL_TYPE_INTEGER, "Gain", 0, 255, 64},
    {V4L2_CID_POWER_LINE_FREQUENCY, V4L2_CTRL_TYPE_MENU, "Power Line Frequency", 0, 2, 2},
    {V4L2_CID_HUE_AUTO, V4L2_CTRL_TYPE_BOOLEAN, "Hue, Automatic", 0, 1, 1},
    {V4L2_CID_CAMERA_CLASS, V4L2_CTRL_TYPE_CTRL_CLASS, "Camera Controls", 0, 0, 0},
    {V4L2_CID_EXPOSURE_AUTO, V4L2_CTRL_TYPE_MENU, "Auto Exposure", 0, 3, V4L2_EXPOSURE_APERTURE_PRIORITY},
    {V4L2_CID_EXPOSURE_ABSOLUTE, V4L2_CTRL_TYPE_INTEGER, "Exposure Time, Absolute", 3, 2047, 166},  // 100 us
};
inline constexpr std::uint32_t kControlCount = sizeof kControls / sizeof kControls[0];

/// Every call returns 0 or an errno.
class Controls {
 public:
  constexpr Controls() {
    for (std::uint32_t i = 0; i < kControlCount; ++i) value_[i] = kControls[i].usual;
  }
  int describe(v4l2_queryctrl& query) const;
  int describe(v4l2_query_ext_ctrl& query) const;
  static int describe(v4l2_querymenu& query);
  int get(std::uint32_t id, std::int32_t& value) const;
  int set(std::uint32_t id, std::int32_t& value);  // `value` returns what was set
  int get(v4l2_ext_controls& list) const;
  int set(v4l2_ext_controls& list, bool only_try);

 private:
  int check(std::uint32_t id, std::int32_t& value, std::uint32_t& row) const;
  [[nodiscard]] std::uint32_t flags(std::uint32_t row) const;
  std::int32_t value_[kControlCount] = {};
};

}  // namespace darwinop::hil::shim
