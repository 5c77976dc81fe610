// Checks whether this computer supports a real-time loop: priority, locked memory, fine clock.
#pragma once

#include <cstdint>
#include <optional>

#include "hal/byte_line.hpp"
#include "hal/cm730/diagnosis/finding.hpp"

namespace darwinop::cm730 {

struct HostFacts {
  int priority = 0;                           // tested SCHED_FIFO priority
  int priority_error = 0;                     // errno; 0: permitted
  int memory_error = 0;                       // errno of locking a controller-sized block; 0: permitted
  std::optional<std::uint64_t> memory_limit;  // bytes; empty: unlimited
  Nanos clock_resolution{0};
};

/// Tests in a separate thread, without lasting effect.
HostFacts measureHost(int priority);
/// The subset that every start of a loop checks.
Nanos clockResolution();
Finding clockRow(Nanos resolution);
Findings diagnoseHost(const HostFacts& facts);

}  // namespace darwinop::cm730
