#include "gap/benchmark/body/drawn_sizes.hpp"

#include <cmath>
#include <stdexcept>

namespace darwinop::gap {
namespace {

/// Another permutation or sign of the axes.
std::vector<double> drawnMap(Rng& rng) {
  const std::vector<double> straight{1, 2, 3};
  std::vector<double> map = straight;
  while (map == straight) {
    if (rng.coin()) rng.shuffle(map);
    for (double& axis : map) axis = std::abs(axis) * (rng.uniform() < 0.3 ? -1 : 1);
  }
  return map;
}

}  // namespace

std::vector<double> oneAxis(Rng& rng, double neutral, double low, double high) {
  std::vector<double> out(3, neutral);
  out[rng.below(3)] += rng.sign() * rng.between(low, high);
  return out;
}

Values drawnFor(const std::string& id, Rng& rng) {
  if (id == "gyro_bias") return {{"bias", oneAxis(rng, 0, 0.08, 0.25)}};
  if (id == "accel_bias") return {{"bias", oneAxis(rng, 0, 0.25, 0.8)}};
  if (id == "accel_scale") return {{"scale", oneAxis(rng, 1, 0.04, 0.1)}};
  if (id == "gyro_scale") return {{"scale", oneAxis(rng, 1, 0.08, 0.3)}};
  if (id == "imu_mounting") return {{"rotation", oneAxis(rng, 0, 0.04, 0.12)}};
  if (id == "gyro_axes" || id == "accel_axes") return {{"map", drawnMap(rng)}};
  if (id == "gyro_lowpass") return {{"time", {rng.between(0.012, 0.05)}}};
  if (id == "gyro_range") return {{"range", {rng.between(0.3, 0.8)}}};
  if (id == "imu_delay") return {{"delay", {rng.between(0.012, 0.05)}}};
  if (id == "floor_friction") return {{"friction", {rng.between(0.15, 0.45)}}};
  if (id == "contact_time") return {{"time", {rng.between(0.02, 0.05)}}};
  if (id == "sole_size") return {{"scale", {rng.between(0.6, 0.85)}}};
  if (id == "floor_tilt") {
    std::vector<double> tilt{0, 0};
    tilt[rng.below(2)] = rng.sign() * rng.between(0.02, 0.05);
    return {{"tilt", tilt}};
  }
  throw std::logic_error("no size for " + id);
}

}  // namespace darwinop::gap
