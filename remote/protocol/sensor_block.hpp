// Sensor block of the protocol extension (docs/remote-protocol.md). sensor_block.cpp defines its layout.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/sensors.hpp"

namespace darwinop::remote {

inline constexpr std::size_t kSensorBlock = 851;  // bytes

/// Appends kSensorBlock bytes. Values are binary32: the rounding error of an angle is below 3e-7 rad.
void writeSensors(const Sensors& seen, std::vector<std::uint8_t>& bytes);

/// `bytes`: kSensorBlock bytes. Accepts any bytes: unknown numbers of faults and states become "none".
[[nodiscard]] Sensors readSensors(std::span<const std::uint8_t> bytes);

}  // namespace darwinop::remote
