#include "gap/live/trunk_direction.hpp"

#include <algorithm>
#include <cmath>

#include "gap/live/thresholds.hpp"

namespace darwinop::gap::live {
namespace {

double norm(const Axes& a) noexcept {
  return std::hypot(a[0], a[1], a[2]);
}

}  // namespace

void TrunkDirection::add(const Axes& accel_m_s2, double dt_s) noexcept {
  if (!std::isfinite(norm(accel_m_s2))) return;
  newest_ = accel_m_s2;
  if (!mean_) {
    mean_ = accel_m_s2;
    return;
  }
  const double share = -std::expm1(-dt_s / kGravityTime);
  for (std::size_t i = 0; i < 3; ++i) (*mean_)[i] += share * (accel_m_s2[i] - (*mean_)[i]);
}

std::optional<Axes> TrunkDirection::up() const noexcept {
  constexpr double kLeast = 0.3 * kGravity;  // below it no direction is known
  if (!mean_ || norm(*mean_) < kLeast) return std::nullopt;
  Axes out = *mean_;
  for (double& value : out) value /= norm(*mean_);
  return out;
}

bool TrunkDirection::isSteady() const noexcept {
  return mean_ && angleBetween(*mean_, newest_) < kSteady;
}

double angleBetween(const Axes& a, const Axes& b) noexcept {
  const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return std::acos(std::clamp(dot / (norm(a) * norm(b)), -1.0, 1.0));
}

Axes alongAxis(const Axes& up) noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    Axes axis{};
    axis[i] = std::copysign(1.0, up[i]);
    if (angleBetween(up, axis) < kAlongAxis) return axis;
  }
  return up;
}

std::optional<double> forwardLean(const Axes& up) noexcept {
  if (std::abs(up[0]) > std::sin(kTurned)) return std::nullopt;
  return std::atan2(-up[2], up[1]);
}

}  // namespace darwinop::gap::live
