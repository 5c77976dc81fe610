// Colours of the pictures of a gait.
#pragma once

namespace darwinop::pictures {

inline constexpr const char* kLeft = "#1f6fb4";
inline constexpr const char* kRight = "#d95f02";
inline constexpr const char* kGrey = "#999";
inline constexpr const char* kBand = "#eeeeee";

}  // namespace darwinop::pictures
