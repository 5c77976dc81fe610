// Merges what the bus said in this cycle into what is known: fresh values replace, missing ones grow old.
#pragma once

#include "core/safe_commands.hpp"
#include "core/sensors.hpp"
#include "hal/servo_bus.hpp"

namespace darwinop::runtime {

void merge(const BusReadings& readings, Sensors& sensors) noexcept;

/// Notes what was sent, so that a recording shows the command beside the measurement.
void noteCommanded(const SafeCommands& sent, Sensors& sensors) noexcept;

}  // namespace darwinop::runtime
