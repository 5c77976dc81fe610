// Message texts.
#pragma once

namespace darwinop::python::messages {

inline constexpr const char* kNoRobot =
    "there is no robot: make a Robot first; after its end its devices cannot be used";
inline constexpr const char* kImageTooSmall = "the image has fewer than 4 bytes for each pixel";

}  // namespace darwinop::python::messages
