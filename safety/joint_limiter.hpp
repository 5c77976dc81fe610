// Limits for one joint: finite, in range, not too fast. Pure functions; what acts is counted.
#pragma once

#include <array>
#include <cstdint>

#include "core/faults.hpp"
#include "core/units.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

using LimitHits = std::array<std::uint32_t, kLimits>;

/// `asked` within `range`; `keep` when it is not finite.
[[nodiscard]] Rad limitGoal(Rad asked, Rad keep, const JointRange& range, LimitHits& hits) noexcept;

/// From `from` towards `to`, by `max_step` rad at most. Both finite.
[[nodiscard]] Rad stepTowards(Rad from, Rad to, double max_step) noexcept;

/// 0.0119..12.21 rad/s (moving speed register 1..1023), sign ignored; 0 is the slowest, as documented for
/// controllers, and no hit. `keep` when not finite.
[[nodiscard]] RadPerSec limitSpeed(RadPerSec asked, RadPerSec keep, LimitHits& hits) noexcept;

/// One count..2.5 N m. Never 0: a torque limit of 0 is how a servo says that it shut itself off.
[[nodiscard]] NewtonMeter limitTorque(NewtonMeter asked, NewtonMeter keep, LimitHits& hits) noexcept;

/// 0..31.75 (register 0..254). `keep` when not finite.
[[nodiscard]] double limitGain(double asked, double keep, LimitHits& hits) noexcept;

}  // namespace darwinop::safety
