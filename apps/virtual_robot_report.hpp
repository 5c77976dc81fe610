// Names of numbers that `darwinop virtual-robot` prints when it ends.
#pragma once

namespace darwinop::app {

inline constexpr const char* kSyncWrites = "sync writes";
inline constexpr const char* kBulkReads = "bulk reads";
inline constexpr const char* kTorqueSwitchedOn = "torque switched on";
inline constexpr const char* kBehindRealTime = "behind real time";

}  // namespace darwinop::app
