// Messages of `darwinop motion`, or the parts that identify them.
#pragma once

namespace darwinop::motion {

inline constexpr const char* kOnlyPlayReads = ": a .motion file; only 'darwinop motion play' reads it";
inline constexpr const char* kReady = "the robot is ready; Ctrl-C ends it";
inline constexpr const char* kLeadIn = "; lead-in of ";
inline constexpr const char* kRepeatsForever = ", then repeats until stopped";
inline constexpr const char* kStoppedOnRequest = "stopped on request\n";

}  // namespace darwinop::motion
