// Merges the readings of a cycle into the sensor image: new values replace old ones; without a reply the age increases.
#pragma once

#include <cstdint>

#include "core/safe_commands.hpp"
#include "core/sensors.hpp"
#include "hal/servo_bus.hpp"

namespace darwinop::runtime {

void merge(const BusReadings& readings, Sensors& sensors) noexcept;

/// Adds `cycles` that did not run to the age of every device.
void missCycles(std::uint32_t cycles, Sensors& sensors) noexcept;

/// Stores the goals sent, so that a recording has command and measurement in one row.
void noteCommanded(const SafeCommands& sent, Sensors& sensors) noexcept;

}  // namespace darwinop::runtime
