// Limits for one joint: finite, in range, not too fast. Pure functions; what acts is counted.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "core/faults.hpp"
#include "core/units.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

using LimitHits = std::array<std::uint32_t, kLimits>;

inline void hit(LimitHits& hits, Limit limit) noexcept {
  ++hits[static_cast<std::size_t>(limit)];
}

/// `value` within low .. high; it is not NaN.
inline double clampCounted(double value, double low, double high, Limit limit, LimitHits& hits) noexcept {
  if (value >= low && value <= high) return value;
  hit(hits, limit);
  return value < low ? low : high;
}

/// `asked` within `range`; `keep` when it is not finite.
[[nodiscard]] inline Rad limitGoal(Rad asked, Rad keep, const JointRange& range, LimitHits& hits) noexcept {
  if (!std::isfinite(asked.value)) {
    hit(hits, Limit::kNotFinite);
    return keep;
  }
  return Rad{clampCounted(asked.value, range.low.value, range.high.value, Limit::kPosition, hits)};
}

/// From `from` towards `to`, by `max_step` rad at most. Both finite.
[[nodiscard]] inline Rad stepTowards(Rad from, Rad to, double max_step) noexcept {
  const double way = to.value - from.value;
  if (std::abs(way) <= max_step) return to;
  return Rad{from.value + std::copysign(max_step, way)};
}

/// 0.0119..12.21 rad/s (moving speed register 1..1023), sign ignored; 0 is the slowest, as documented for
/// controllers, and no hit. `keep` when not finite.
[[nodiscard]] RadPerSec limitSpeed(RadPerSec asked, RadPerSec keep, LimitHits& hits) noexcept;

/// One count..2.5 N m. Never 0: a torque limit of 0 is how a servo says that it shut itself off.
[[nodiscard]] NewtonMeter limitTorque(NewtonMeter asked, NewtonMeter keep, LimitHits& hits) noexcept;

/// 0..31.75 (register 0..254). `keep` when not finite.
[[nodiscard]] double limitGain(double asked, double keep, LimitHits& hits) noexcept;

}  // namespace darwinop::safety
