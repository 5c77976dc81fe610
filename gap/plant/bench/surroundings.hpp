// External inputs of a bench: the logged temperature, and noise.
#pragma once

#include <cstdint>

#include "core/random.hpp"
#include "gap/plant/bench/roll_out.hpp"
#include "twin/servo/effect.hpp"

namespace darwinop::gap {

/// First-order Gauss-Markov process with standard deviation `sigma` and correlation time `time_s`.
class GaussMarkov {
 public:
  GaussMarkov(double sigma, double time_s, double step_s, std::uint64_t seed);
  double next();

 private:
  double nearlyNormal();

  Rng rng_;
  double keep_, add_, value_;
};

/// The first effect of the servo.
class Surroundings final : public twin::Effect {
 public:
  /// `temperature_c` belongs to the caller, who changes it as the run goes on. The encoder shows where the joint is
  /// `ahead_s` later.
  Surroundings(const double& temperature_c, const Disturbance* disturbance, double step_s, double ahead_s = 0);

  [[nodiscard]] const twin::EffectInfo& info() const noexcept override;
  [[nodiscard]] std::uint8_t hooks() const noexcept override {
    return static_cast<std::uint8_t>(kCommandHook | (noisy_ ? kMechanicsHook : 0) |
                                     (ahead_s_ > 0 ? kSensorHook | kControllerHook : 0));
  }
  void reset(const twin::Signals& now) noexcept override {
    last_set_point_rad_ = now.set_point_rad;
    last_position_rad_ = now.position_rad;
  }
  void command(twin::Signals& s, double dt_s) noexcept override;
  void sensor(twin::Signals& s, double dt_s) noexcept override;
  void controller(twin::Signals& s, double dt_s) noexcept override;
  void mechanics(twin::Signals& s) noexcept override { s.extra_torque_nm += torque_nm_; }

 private:
  const double& temperature_c_;
  double ahead_s_;
  bool noisy_;
  GaussMarkov torque_;
  double torque_nm_ = 0, last_set_point_rad_ = 0, last_position_rad_ = 0;
};

}  // namespace darwinop::gap
