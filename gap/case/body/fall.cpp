#include "gap/case/body/fall.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/units.hpp"

namespace darwinop::gap {
namespace {

constexpr double kFallen = kPi / 3;  // rad of tilt against the start: no gait or squat comes near
constexpr double kFallWindow = 0.2;  // s over which the accelerometer is averaged: footsteps are shorter

/// Mean of each axis over the rows [from, to) that have one.
Axes meanOf(const AxesColumns& columns, std::size_t from, std::size_t to) {
  Axes mean{};
  for (std::size_t axis = 0; axis < mean.size(); ++axis) {
    double count = 0;
    for (std::size_t row = from; row < to; ++row)
      if (const double value = columns[axis][row]; !std::isnan(value)) mean[axis] += value, count += 1;
    mean[axis] /= count;
  }
  return mean;
}

double product(const Axes& a, const Axes& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double angleBetween(const Axes& a, const Axes& b) {
  return std::acos(std::clamp(product(a, b) / std::sqrt(product(a, a) * product(b, b)), -1.0, 1.0));
}

}  // namespace

std::optional<std::size_t> rowOfFall(const std::vector<double>& time_s, const AxesColumns& accel_m_s2) {
  const std::size_t rows = time_s.size();
  if (rows < 2) return std::nullopt;
  const double period_s = (time_s.back() - time_s.front()) / static_cast<double>(rows - 1);
  const auto window = std::max<std::size_t>(1, static_cast<std::size_t>(kFallWindow / period_s));
  if (rows < 2 * window) return std::nullopt;
  const Axes start = meanOf(accel_m_s2, 0, window);
  for (std::size_t row = window; row + window <= rows; ++row)
    if (angleBetween(start, meanOf(accel_m_s2, row, row + window)) > kFallen) return row;
  return std::nullopt;
}

}  // namespace darwinop::gap
