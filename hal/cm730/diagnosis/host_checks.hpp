// Checks whether this computer supports a real-time loop: priority, locked memory, constant speed, fine clock.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/cm730/diagnosis/finding.hpp"

namespace darwinop::cm730 {

struct HostFacts {
  int priority = 0;                           // tested SCHED_FIFO priority
  int priority_error = 0;                     // errno; 0: permitted
  int memory_error = 0;                       // errno of locking a controller-sized block; 0: permitted
  std::optional<std::uint64_t> memory_limit;  // bytes; empty: unlimited
  std::set<std::string> governors;            // of its processors' speed; empty: the speed is constant
  Nanos clock_resolution{0};
};

inline const std::string kSysCpu = "/sys/devices/system/cpu";

/// Tests in a separate thread, without lasting effect.
HostFacts measureHost(int priority);
/// The kernel's rules for the speed of the processors, of each that has one.
std::set<std::string> cpuGovernors(const std::string& folder = kSysCpu);
/// The subset that every start of a loop checks.
Nanos clockResolution();
Finding clockRow(Nanos resolution);
Findings diagnoseHost(const HostFacts& facts);

}  // namespace darwinop::cm730
