// What `darwinop virtual-robot` prints while it runs and when it ends.
#pragma once

#include <cstdint>

#include "hal/byte_line.hpp"

namespace darwinop::hil {
class PtyHost;
class VirtualRobot;
}  // namespace darwinop::hil

namespace darwinop::app {

inline constexpr const char* kSyncWrites = "sync writes";
inline constexpr const char* kBulkReads = "bulk reads";
inline constexpr const char* kTorqueSwitchedOn = "torque switched on";
inline constexpr const char* kBehindRealTime = "behind real time";

/// Prints all joint angles in one line, and where the trunk of a body with physics is, on SIGUSR1.
void printJoints(hil::PtyHost& host);
/// Warns once. Returns true if it has warned.
bool warnOfLag(const hil::PtyHost& host, bool physics);
void report(const hil::VirtualRobot& robot, std::uint64_t torque_on, double seconds, Nanos lag);

}  // namespace darwinop::app
