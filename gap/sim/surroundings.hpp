// What acts on a bench from outside and is no effect of the servo: the temperature that the log tells, and noise.
#pragma once

#include <random>

#include "gap/sim/roll_out.hpp"
#include "twin/servo/effect.hpp"

namespace darwinop::gap {

/// A noise with a memory: first order, standard deviation `sigma` after any time.
class Wander {
 public:
  Wander(double sigma, double time_s, double step_s, std::uint64_t seed);
  double next();

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  double keep_, add_, value_;
};

/// Sits in the servo as an effect, first in its row.
class Surroundings final : public twin::Effect {
 public:
  /// `temperature_c` belongs to the caller, who changes it as the run goes on.
  Surroundings(const double& temperature_c, const Disturbance* disturbance, double step_s);

  [[nodiscard]] const twin::EffectInfo& info() const noexcept override;
  [[nodiscard]] std::uint8_t hooks() const noexcept override {
    return static_cast<std::uint8_t>(kCommandHook | (noisy_ ? kMechanicsHook : 0));
  }
  void command(twin::Signals& s, double dt_s) noexcept override;
  void mechanics(twin::Signals& s) noexcept override { s.extra_torque_nm += torque_nm_; }

 private:
  const double& temperature_c_;
  bool noisy_;
  Wander torque_;
  double torque_nm_ = 0;
};

}  // namespace darwinop::gap
