// Message texts.
#pragma once

namespace darwinop::python::messages {

inline constexpr const char* kNoRobot =
    "there is no robot: make a Robot first; after its end its devices cannot be used";
// After the name of a device.
inline constexpr const char* kOfAnotherClass = ": this device is of another class; getDevice() returns it";
inline constexpr const char* kImageTooSmall = "the image has fewer than 4 bytes for each pixel";

}  // namespace darwinop::python::messages
