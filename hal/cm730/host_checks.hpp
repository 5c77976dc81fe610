// Whether this computer lets a loop be punctual: real-time priority, locked memory, a fine clock.
#pragma once

#include <cstdint>
#include <optional>

#include "hal/byte_line.hpp"
#include "hal/cm730/finding.hpp"

namespace darwinop::cm730 {

struct HostFacts {
  int priority = 0;                           // SCHED_FIFO priority that was tried
  int priority_error = 0;                     // errno; 0: permitted
  int memory_error = 0;                       // errno of locking as much memory as a controller has; 0: permitted
  std::optional<std::uint64_t> memory_limit;  // bytes; nothing: unlimited
  Nanos clock_resolution{0};
};

/// Tries it in a thread of its own; nothing of it stays.
HostFacts measureHost(int priority);
/// The part of it that every start of a loop looks at.
Nanos clockResolution();
Finding clockRow(Nanos resolution);
Findings diagnoseHost(const HostFacts& facts);

}  // namespace darwinop::cm730
