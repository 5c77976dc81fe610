// Loop statistics as text: one line with a stable format for scripts, several lines for the user.
#pragma once

#include <string>
#include <vector>

#include "core/sensors.hpp"
#include "runtime/loop_stats.hpp"

namespace darwinop::runtime {

/// Names of stale devices, the board first: "CM-730", "Neck".
std::vector<std::string> staleDevices(const Sensors& sensors);

/// "report: cycles=625 overruns=0 wake_p50_us=34 ... stale=0". Stable format: names and order never change; "nan":
/// not measured. bus_ratio: median bus time / median wire time.
std::string reportLine(const StatsView& stats, const Sensors& last);

/// The same for the user: several lines, with the names of stale devices.
std::string reportText(const StatsView& stats, const Sensors& last);

/// The robot's part of `darwinop runtime --status`: state, faults with remedies, battery.
std::string robotText(const Sensors& last);

}  // namespace darwinop::runtime
