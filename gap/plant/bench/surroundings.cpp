#include "gap/plant/bench/surroundings.hpp"

#include <cmath>

#include "gap/plant/bench/internal_effect.hpp"

namespace darwinop::gap {
namespace {

const twin::EffectInfo kSurroundings =
    internalEffect("surroundings", "temperature and noise of the bench", twin::Place::kLoad);

}  // namespace

GaussMarkov::GaussMarkov(double sigma, double time_s, double step_s, std::uint64_t seed)
    : rng_{seed}, keep_{std::exp(-step_s / time_s)}, add_{sigma * std::sqrt(1 - keep_ * keep_)} {
  value_ = sigma * nearlyNormal();
}

double GaussMarkov::next() {
  return value_ = keep_ * value_ + add_ * nearlyNormal();
}

// The sum of four quarters of a draw: mean 0, variance 1. The process sums dozens of them.
double GaussMarkov::nearlyNormal() {
  const std::uint64_t z = rng_.next();
  constexpr std::uint64_t kQuarter = 0xffff;
  const std::uint64_t sum = (z & kQuarter) + (z >> 16 & kQuarter) + (z >> 32 & kQuarter) + (z >> 48);
  static const double kScale = std::sqrt(3.0) / 65'536;  // each is uniform, of variance 65536^2 / 12
  return (static_cast<double>(static_cast<std::int64_t>(sum)) - 2.0 * kQuarter) * kScale;
}

Surroundings::Surroundings(const double& temperature_c, const Disturbance* disturbance, double step_s, double ahead_s)
    : temperature_c_{temperature_c},
      ahead_s_{ahead_s},
      noisy_{disturbance != nullptr},
      torque_{noisy_ ? disturbance->torque_nm : 0, noisy_ ? disturbance->torque_time_s : 1, step_s,
              noisy_ ? disturbance->seed : 0} {}

const twin::EffectInfo& Surroundings::info() const noexcept {
  return kSurroundings;
}

void Surroundings::command(twin::Signals& s, double /*dt_s*/) noexcept {
  s.temperature_c = temperature_c_;  // the servo's own heat then starts from what was measured
  if (noisy_) torque_nm_ = torque_.next();
}

// By the encoder's own speed: in the play of a gear the motor has another.
void Surroundings::sensor(twin::Signals& s, double dt_s) noexcept {
  s.measured_rad += ahead_s_ * (s.position_rad - last_position_rad_) / dt_s;
  last_position_rad_ = s.position_rad;
}

// A profile that is on its way has gone a whole period; the mean of many small ones is half of that. One that gathers
// speed has gathered it at the beginning of each period, which is as much again. Law speed_p has no profile.
void Surroundings::controller(twin::Signals& s, double dt_s) noexcept {
  const double share = std::isfinite(s.profile_accel_rad_s2) ? 2 : std::isfinite(s.profile_speed_rad_s) ? 1 : 0;
  if (s.law == twin::Law::kVoltageP) s.error_rad -= share * ahead_s_ * (s.set_point_rad - last_set_point_rad_) / dt_s;
  last_set_point_rad_ = s.set_point_rad;
}

}  // namespace darwinop::gap
