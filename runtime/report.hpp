// Loop figures as text: one stable line for scripts, some lines for people.
#pragma once

#include <string>
#include <vector>

#include "core/sensors.hpp"
#include "runtime/loop_stats.hpp"

namespace darwinop::runtime {

/// Age in cycles from which on a device counts as stale. Single losses are normal on a serial line.
inline constexpr std::uint32_t kStaleAge = 4;

/// Names of the devices that are stale, the board first: "CM-730", "Neck".
std::vector<std::string> staleDevices(const Sensors& sensors);

/// "report: cycles=625 overruns=0 wake_p50_us=34 ... stale=0": names and order never change, "nan" where nothing was
/// measured. bus_ratio is the median bus time over the median wire time.
std::string reportLine(const StatsView& stats, const Sensors& last);

/// The same for a person, several lines, stale devices by name.
std::string reportText(const StatsView& stats, const Sensors& last);

/// What `darwinop runtime --status` says of the robot: state, faults and what to do about them, battery.
std::string robotText(const Sensors& last);

}  // namespace darwinop::runtime
