// Ends of phases that the robot decides: joints arrived, joints at rest, the robot has fallen.
#include "experiments/run/watch.hpp"

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"

namespace darwinop::experiments {
namespace {
constexpr double kStill = 3.5 * kRadPerTick;  // three ticks: a servo at rest may flicker by one
constexpr double kStillFor = 0.5;             // s, more than half a swing of a hanging arm
}  // namespace

void FallWatch::update(const double* counts, double dt_s) {
  const double x = (counts[0] - 512) / 128, y = (counts[1] - 512) / 128, z = (counts[2] - 512) / 128;
  const double g = std::hypot(x, y, z);
  if (!(g > 0.5 && g < 1.5)) return;
  tilted_s_ = z / g < std::cos(kPi / 4) ? tilted_s_ + dt_s : 0;
}

bool EndWatch::over(const Positions& seen, bool fallen, double t) {
  switch (phase_.until) {
    case Until::kArrival:
      return arrived(seen);
    case Until::kRest:
      return resting(seen, t);
    case Until::kFallen:
      return fallen;
    default:
      return false;
  }
}

/// Within the distance; a joint that is pushed by a torque has no reason to stop there, so passing counts, too.
bool EndWatch::arrived(const Positions& seen) const {
  return std::ranges::all_of(phase_.joints, [&](const Moved& moved) {
    const std::size_t i = index(moved.joint);
    const double to = moved.sign * *phase_.arrive_at;
    return std::abs(seen[i] - to) <= phase_.within ||
           (phase_.torque != TorqueMode::kLimit && (begin_[i] - to) * (seen[i] - to) < 0);
  });
}

bool EndWatch::resting(const Positions& seen, double t) {
  for (const Moved& moved : phase_.joints)
    if (const std::size_t i = index(moved.joint); !(std::abs(seen[i] - still_[i]) <= kStill)) {
      still_ = seen;
      still_since_ = t;
    }
  return t - still_since_ >= kStillFor;
}

}  // namespace darwinop::experiments
