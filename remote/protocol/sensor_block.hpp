// The sensor block of the protocol extension (docs/remote-protocol.md). sensor_block.cpp defines its layout.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/sensors.hpp"

namespace darwinop::remote {

inline constexpr std::size_t kSensorBlock = 838;  // bytes

/// Adds kSensorBlock bytes. Values leave as binary32: an angle is off by less than 3e-7 rad.
void writeSensors(const Sensors& seen, std::vector<std::uint8_t>& bytes);

/// `bytes`: kSensorBlock of them. Any bytes are an image: numbers of faults and states that are none become none.
[[nodiscard]] Sensors readSensors(std::span<const std::uint8_t> bytes);

}  // namespace darwinop::remote
