// Limits for one joint: finite, in range, rate-limited. Pure functions; each limit that acts is counted.
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

/// `value` clamped to low .. high; must not be NaN.
inline double clampCounted(double value, double low, double high, Limit limit, LimitHits& hits) noexcept {
  if (value >= low && value <= high) return value;
  hit(hits, limit);
  return value < low ? low : high;
}

/// `asked` clamped to `range`; `keep` if it is not finite.
[[nodiscard]] inline Rad limitGoal(Rad asked, Rad keep, const JointRange& range, LimitHits& hits) noexcept {
  if (!std::isfinite(asked.value)) {
    hit(hits, Limit::kNotFinite);
    return keep;
  }
  return Rad{clampCounted(asked.value, range.low.value, range.high.value, Limit::kPosition, hits)};
}

/// One step from `from` towards `to`, at most `max_step` rad. Both must be finite.
[[nodiscard]] inline Rad stepTowards(Rad from, Rad to, double max_step) noexcept {
  const double way = to.value - from.value;
  if (std::abs(way) <= max_step) return to;
  return Rad{from.value + std::copysign(max_step, way)};
}

/// 0.0119..12.21 rad/s (moving speed register 1..1023), sign ignored; 0 becomes the slowest speed, as documented for
/// controllers, and is not counted. `keep` if not finite.
[[nodiscard]] RadPerSec limitSpeed(RadPerSec asked, RadPerSec keep, LimitHits& hits) noexcept;

/// One count..2.5 N m. Never 0: a servo reports an automatic shutdown as torque limit 0. `keep` if not finite.
[[nodiscard]] NewtonMeter limitTorque(NewtonMeter asked, NewtonMeter keep, LimitHits& hits) noexcept;

/// 0..31.75 (register 0..254). `keep` if not finite.
[[nodiscard]] double limitGain(double asked, double keep, LimitHits& hits) noexcept;

}  // namespace darwinop::safety
