// Gyroscope: angular rate of the trunk. Accelerometer: velocity change of its site in a cycle, minus gravity.
#include "twin/body/imu.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "core/units.hpp"

namespace darwinop::twin {
namespace {

std::uint64_t mix(std::uint64_t x) noexcept {
  return splitMix(x + kSplitMixStep);
}

// Standard normal (Box-Muller).
double normal(std::uint64_t seed, std::uint64_t sample, std::uint64_t channel) noexcept {
  const std::uint64_t first = mix(mix(seed) ^ (sample * 8 + channel));
  constexpr double kUnit = 0x1p-53;
  const double u = (static_cast<double>(first >> 11U) + 0.5) * kUnit;  // never 0
  const double v = uniformFrom(mix(first));
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * kPi * v);
}

double distorted(double value, double scale, double bias, double noise, double range) noexcept {
  return std::clamp(value * scale + bias + noise, -range, range);
}

}  // namespace

Imu::Imu(const mjModel& m, const BodyMap& map, const ImuSettings& settings, std::uint64_t seed, double cycle_s)
    : settings_{settings},
      seed_{seed},
      qpos_{map.trunk_qpos},
      dof_{map.trunk_dof},
      gyro_lag_{m.opt.timestep, settings.gyro_lowpass_s, settings.delay_s},
      accel_lag_{m.opt.timestep, 0, settings.delay_s},
      velocities_(static_cast<std::size_t>(std::max(1L, std::lround(cycle_s / m.opt.timestep)))) {
  mju_copy3(site_, m.site_pos + 3 * map.accelerometer);
  mju_negQuat(gyro_axes_, mountedAt(m.site_quat + 4 * map.gyro, settings).data());
  mju_negQuat(accel_axes_, mountedAt(m.site_quat + 4 * map.accelerometer, settings).data());
  for (std::size_t i = 0; i < 3; ++i) {
    gyro_read_[i] = readAxis(settings.gyro_axes[i]);
    accel_read_[i] = readAxis(settings.accel_axes[i]);
  }
}

void Imu::siteVelocity(const mjData& d, mjtNum* velocity) const noexcept {
  mjtNum lever[3];
  mju_cross(lever, d.qvel + dof_ + 3, site_);
  mju_rotVecQuat(velocity, lever, d.qpos + qpos_ + 3);
  mju_addTo3(velocity, d.qvel + dof_);
}

void Imu::reset(const mjModel& m, const mjData& d) noexcept {
  siteVelocity(d, velocities_.front().data());
  steps_ = 0;
  mju_zero3(acceleration_);
  gyro_lag_.fill(trueRate(d));
  accel_lag_.fill(trueAcceleration(m, d));
}

void Imu::update(const mjModel& m, const mjData& d) noexcept {
  std::array<mjtNum, 3> now{};
  siteVelocity(d, now.data());
  const std::size_t size = velocities_.size(), span = std::min(++steps_, size);  // fewer right after the reset
  mju_sub3(acceleration_, now.data(), velocities_[(steps_ - span) % size].data());
  mju_scl3(acceleration_, acceleration_, 1 / (static_cast<double>(span) * m.opt.timestep));
  velocities_[steps_ % size] = now;
  if (gyro_lag_.acts()) gyro_lag_.next(trueRate(d));
  if (accel_lag_.acts()) accel_lag_.next(trueAcceleration(m, d));
}

Imu::Axes Imu::trueRate(const mjData& d) const noexcept {
  Axes sensed{};
  mju_rotVecQuat(sensed.data(), d.qvel + dof_ + 3, gyro_axes_);
  return sensed;
}

Imu::Axes Imu::trueAcceleration(const mjModel& m, const mjData& d) const noexcept {
  mjtNum world[3], upright[4], trunk[3];
  mju_sub3(world, acceleration_, m.opt.gravity);
  mju_negQuat(upright, d.qpos + qpos_ + 3);
  mju_rotVecQuat(trunk, world, upright);
  Axes sensed{};
  mju_rotVecQuat(sensed.data(), trunk, accel_axes_);
  return sensed;
}

Imu::Axes Imu::gyro(const mjData& d, std::uint64_t sample) const noexcept {
  const Axes sensed = gyro_lag_.acts() ? gyro_lag_.now() : trueRate(d);
  Axes out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double noise = settings_.gyro_noise_rad_s > 0 ? settings_.gyro_noise_rad_s * normal(seed_, sample, i) : 0;
    out[i] = distorted(gyro_read_[i].sign * sensed[gyro_read_[i].index], settings_.gyro_scale[i],
                       settings_.gyro_bias_rad_s[i], noise, settings_.gyro_range_rad_s);
  }
  return out;
}

Imu::Axes Imu::accelerometer(const mjModel& m, const mjData& d, std::uint64_t sample) const noexcept {
  const Axes sensed = accel_lag_.acts() ? accel_lag_.now() : trueAcceleration(m, d);
  Axes out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double noise = settings_.accel_noise_m_s2 > 0 ? settings_.accel_noise_m_s2 * normal(seed_, sample, 4 + i) : 0;
    out[i] = distorted(accel_read_[i].sign * sensed[accel_read_[i].index], settings_.accel_scale[i],
                       settings_.accel_bias_m_s2[i], noise, settings_.accel_range_m_s2);
  }
  return out;
}

}  // namespace darwinop::twin
