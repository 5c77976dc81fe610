// Limits for one joint.
#include "safety/joint_limiter.hpp"

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"

namespace darwinop::safety {
namespace {

constexpr double kSlowest = kRadPerSecPerCount;
constexpr double kFastest = 1023 * kRadPerSecPerCount;  // 12.2127 rad/s
constexpr double kLeastTorque = kMaxTorqueNm / kTorqueMax;
constexpr double kMaxPGain = 254 / 8.0;

void hit(LimitHits& hits, Limit limit) noexcept {
  ++hits[static_cast<std::size_t>(limit)];
}

double clampCounted(double value, double low, double high, Limit limit, LimitHits& hits) noexcept {
  if (value < low || value > high) hit(hits, limit);
  return std::clamp(value, low, high);
}

}  // namespace

Rad limitGoal(Rad asked, Rad keep, const JointRange& range, LimitHits& hits) noexcept {
  if (!std::isfinite(asked.value)) {
    hit(hits, Limit::kNotFinite);
    return keep;
  }
  return Rad{clampCounted(asked.value, range.low.value, range.high.value, Limit::kPosition, hits)};
}

Rad stepTowards(Rad from, Rad to, double max_step) noexcept {
  const double way = to.value - from.value;
  if (std::abs(way) <= max_step) return to;
  return Rad{from.value + std::copysign(max_step, way)};
}

RadPerSec limitSpeed(RadPerSec asked, RadPerSec keep, LimitHits& hits) noexcept {
  if (!std::isfinite(asked.value)) {
    hit(hits, Limit::kNotFinite);
    return keep;
  }
  return RadPerSec{std::max(kSlowest, clampCounted(std::abs(asked.value), 0, kFastest, Limit::kSpeed, hits))};
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
