// Limits for one joint.
#include "safety/joint_limiter.hpp"

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"

namespace darwinop::safety {
RadPerSec limitSpeed(RadPerSec asked, RadPerSec keep, LimitHits& hits) noexcept {
  if (!std::isfinite(asked.value)) {
    hit(hits, Limit::kNotFinite);
    return keep;
  }
  return RadPerSec{
      std::max(kRadPerSecPerCount, clampCounted(std::abs(asked.value), 0, kRegisterSpeed, Limit::kSpeed, hits))};
}

NewtonMeter limitTorque(NewtonMeter asked, NewtonMeter keep, LimitHits& hits) noexcept {
  if (!std::isfinite(asked.value)) {
    hit(hits, Limit::kNotFinite);
    return keep;
  }
  return NewtonMeter{std::max(kLeastTorque, clampCounted(asked.value, 0, kMaxTorqueNm, Limit::kTorque, hits))};
}

double limitGain(double asked, double keep, LimitHits& hits) noexcept {
  if (!std::isfinite(asked)) {
    hit(hits, Limit::kNotFinite);
    return keep;
  }
  return clampCounted(asked, 0, kMaxPGain, Limit::kGain, hits);
}

}  // namespace darwinop::safety
