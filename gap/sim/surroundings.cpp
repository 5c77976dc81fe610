#include "gap/sim/surroundings.hpp"

#include <cmath>

#include "gap/sim/unlisted.hpp"

namespace darwinop::gap {
namespace {

const twin::EffectInfo kSurroundings =
    unlisted("surroundings", "temperature and noise of the bench", twin::Place::kLoad);

}  // namespace

Wander::Wander(double sigma, double time_s, double step_s, std::uint64_t seed)
    : random_{seed}, keep_{std::exp(-step_s / time_s)}, add_{sigma * std::sqrt(1 - keep_ * keep_)} {
  value_ = sigma * normal_(random_);
}

double Wander::next() {
  return value_ = keep_ * value_ + add_ * normal_(random_);
}

Surroundings::Surroundings(const double& temperature_c, const Disturbance* disturbance, double step_s)
    : temperature_c_{temperature_c},
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

}  // namespace darwinop::gap
