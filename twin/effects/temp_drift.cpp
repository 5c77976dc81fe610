// Effect: temperature dependence of friction and winding resistance. Scales all friction listed before it.
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
              .secondary = true,
              .fixed = true},
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
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kTemperature, LogFeature::kLongSession});
constexpr auto kOtherNames = std::to_array<OtherName>({{"temp_beta", "rate"}, {"b", "rate"}});

class TempDrift final : public EffectOf<kTempDrift, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMotorHook | kMechanicsHook; }
  void reset(const Signals& now) noexcept override { update(now); }
  void motor(Signals& s, double /*dt_s*/) noexcept override { s.resistance_ohm *= update(s); }
  void mechanics(Signals& s) noexcept override {
    s.dry_friction_nm *= friction_factor_;
    s.damping_nms_rad *= friction_factor_;
  }

 private:
  // Sets the friction factor and returns the resistance factor.
  double update(const Signals& s) noexcept {
    const auto& [rate, reference, copper] = values_;
    const double difference_k = s.temperature_c - reference;
    friction_factor_ = std::exp(-rate * difference_k);
    return 1 + copper * difference_k;
  }

  double friction_factor_ = 1;
};

}  // namespace

const EffectInfo kTempDrift{{
    .id = "temp_drift",
    .title = "temperature drift of friction and resistance",
    .part = LoopPart::kFriction,
    .equation = "F = F exp(-rate (T - reference)); R = R (1 + copper (T - reference))",
    .signature = "The same log differs with session time or reported temperature.",
    .separated_by = "Repeat the first log at the end of the session.",
    .source = "Copper: 0.39 % per kelvin; range of rate assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {},
    .exports = {.webots = approximated("friction and torque at one temperature, written beside them"),
                .mujoco = approximated("friction and torque at one temperature, written beside them"),
                .urdf = approximated("friction and effort at one temperature, written beside them")},
    .other_names = kOtherNames,
    .make = makeEffect<TempDrift>,
}};

}  // namespace darwinop::twin
