// Which path is the camera's.
#pragma once

namespace darwinop::hil::shim {

/// $DARWINOP_VIRTUAL_CAMERA_DEVICE. The environment is asked each time: a test may set it after the start.
const char* devicePath();
/// False for every path while $DARWINOP_VIRTUAL_CAMERA is not set.
bool isCamera(const char* path);
/// What a program that wants to know what kind of device 81:0 is looks into.
bool isDescription(const char* path);

inline constexpr unsigned kMajor = 81, kMinor = 0;  // video4linux, /dev/video0

}  // namespace darwinop::hil::shim
