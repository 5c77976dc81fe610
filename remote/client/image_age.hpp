// Ages an image of the robot while no new one arrives.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/sensors.hpp"
#include "runtime/clock.hpp"

namespace darwinop::remote {

inline void age(Freshness& freshness, std::uint64_t cycles) {
  if (freshness.ever())
    freshness.age = static_cast<std::uint32_t>(std::min<std::uint64_t>(freshness.age + cycles, Freshness::kNever - 1));
}

/// Ages an image by a number of cycles without a new image.
inline void ageImage(Sensors& image, std::uint64_t cycles, Nanos period) {
  image.cycle += cycles;
  image.time_ns += static_cast<std::int64_t>(cycles) * period.count();
  for (JointSensors& joint : image.joint) {
    age(joint.motion, cycles);
    age(joint.polled, cycles);
  }
  age(image.board.motion, cycles);
}

}  // namespace darwinop::remote
