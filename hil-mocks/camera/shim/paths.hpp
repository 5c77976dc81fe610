// Path of the virtual camera device.
#pragma once

namespace darwinop::hil::shim {

/// $DARWINOP_VIRTUAL_CAMERA_DEVICE. Read each time: a test may set it after the start.
const char* devicePath();
/// False for every path if $DARWINOP_VIRTUAL_CAMERA is not set.
bool isCamera(const char* path);
/// sysfs file that describes device 81:0.
bool isDescription(const char* path);

inline constexpr unsigned kMajor = 81, kMinor = 0;  // video4linux, /dev/video0

}  // namespace darwinop::hil::shim
