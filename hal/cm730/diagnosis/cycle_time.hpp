// Duration of the loop's cycle, from the measurements of a probe.
#pragma once

#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

/// Share of a period reserved for wake-up latency and computation.
inline constexpr Nanos kHeadroom{1'000'000};

/// Of all readable servos together.
Nanos returnDelays(const RobotFacts& facts);
/// USB overhead of an exchange: the request waits for a USB frame, and the FTDI chip delays the end of the reply. A
/// BulkRead's replies have no gaps and fill packets, so a cycle pays this once, as a short read does.
Nanos usbTime(const RobotFacts& facts);
/// All bytes of a full cycle with twenty servos.
Nanos cycleWireTime();

/// Duration of a full cycle with twenty servos: bytes, return delays and USB overhead.
Nanos cycleTime(const RobotFacts& facts);
/// Whether the cycle fits the period. A goals-only write (most cycles) must leave kHeadroom; the full write (one cycle
/// in 16, and those that change a speed, torque limit or gain) must fit. The USB overhead must stay within the bus's
/// reply margin.
bool cycleFits(const RobotFacts& facts);

}  // namespace darwinop::cm730
