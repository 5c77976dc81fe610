// Grease that gets thin and copper that gets worse as the servo warms up. Acts on all friction listed before it.
#include <cmath>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kTempDrift;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "rate",
              .unit = "1/K",
              .meaning = "relative friction loss per kelvin",
              .low = -0.02,
              .high = 0.1,
              .neutral = 0,
              .typical = 0.01},
    Parameter{.key = "reference",
              .unit = "degC",
              .meaning = "temperature at which the model file's values hold",
              .low = 0,
              .high = 60,
              .neutral = 25,
              .typical = 25,
              .secondary = true},
    Parameter{.key = "copper",
              .unit = "1/K",
              .meaning = "relative resistance growth per kelvin",
              .low = 0,
              .high = 0.005,
              .neutral = 0,
              .typical = 0,
              .secondary = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"coulomb", "viscous", "resistance_error"});

class TempDrift final : public EffectOf<kTempDrift, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMotorHook | kMechanicsHook; }
  void reset(const Signals& now) noexcept override { warm(now); }
  // Heat is slow: once a firmware period is often enough.
  void motor(Signals& s, double /*dt_s*/) noexcept override { s.resistance_ohm *= warm(s); }
  void mechanics(Signals& s) noexcept override {
    s.dry_friction_nm *= friction_factor_;
    s.damping_nms_rad *= friction_factor_;
  }

 private:
  // Gives the factor of the resistance.
  double warm(const Signals& s) noexcept {
    const auto& [rate, reference, copper] = values_;
    const double warmer_k = s.temperature_c - reference;
    friction_factor_ = std::exp(-rate * warmer_k);
    return 1 + copper * warmer_k;
  }

  double friction_factor_ = 1;
};

}  // namespace

const EffectInfo kTempDrift{
    .id = "temp_drift",
    .title = "temperature drift of friction and resistance",
    .place = Place::kFriction,
    .equation = "F = F exp(-rate (T - reference)); R = R (1 + copper (T - reference))",
    .signature = "The same log differs with session time or reported temperature.",
    .separated_by =
        "Repeat the first log at the end of the session. Cold logs alone cannot separate it from dry friction.",
    .source = "Copper: 0.39 % per kelvin; range of rate assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<TempDrift>,
};

}  // namespace darwinop::twin
