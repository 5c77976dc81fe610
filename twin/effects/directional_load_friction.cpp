// Effect: gear friction with different coefficients for motor torque and load torque.
#include <cmath>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kDirectionalLoadFriction;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "motor",
              .unit = "",
              .meaning = "friction per torque of the motor",
              .low = 0,
              .high = 0.5,
              .neutral = 0,
              .typical = 0.1,
              .logarithmic = true},
    Parameter{.key = "load",
              .unit = "",
              .meaning = "friction per torque of the load",
              .low = 0,
              .high = 0.5,
              .neutral = 0,
              .typical = 0.05,
              .logarithmic = true},
    Parameter{.key = "slow_motor",
              .unit = "",
              .meaning = "the same, only at low speed",
              .low = 0,
              .high = 0.5,
              .neutral = 0,
              .typical = 0,
              .secondary = true},
    Parameter{.key = "slow_load",
              .unit = "",
              .meaning = "the same, only at low speed",
              .low = 0,
              .high = 0.5,
              .neutral = 0,
              .typical = 0,
              .secondary = true},
    Parameter{.key = "slow_speed",
              .unit = "rad/s",
              .meaning = "where the low-speed part has faded to 37 %",
              .low = 0.05,
              .high = 3,
              .neutral = 0.2,
              .typical = 0.2,
              .logarithmic = true,
              .secondary = true},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"load_dependent_friction", "com_mass", "quadratic_load_friction"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kPayloads});
constexpr auto kOtherNames =
    std::to_array<OtherName>({{"Km", "motor"}, {"Ke", "load"}, {"K_motor", "motor"}, {"K_ext", "load"}});

class DirectionalLoadFriction final : public EffectOf<kDirectionalLoadFriction, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [motor, load, slow_motor, slow_load, slow_speed] = values_;
    s.dry_friction_nm += std::abs(motor * s.motor_torque_nm - load * s.external_torque_nm);
    if (slow_motor == 0 && slow_load == 0) return;
    s.dry_friction_nm += std::abs(slow_motor * s.motor_torque_nm - slow_load * s.external_torque_nm) *
                         std::exp(-std::abs(s.velocity_rad_s) / slow_speed);
  }
};

}  // namespace

const EffectInfo kDirectionalLoadFriction{{
    .id = "directional_load_friction",
    .title = "directional load-dependent friction",
    .part = LoopPart::kFriction,
    .equation = "F += |motor tm - load te| + |slow_motor tm - slow_load te| exp(-|w| / slow_speed)",
    .signature = "Lifting needs more, or lowering less, than load-proportional friction predicts.",
    .separated_by = "Move up and down under load at two payloads; push back by hand with torque off.",
    .source = "Rhoban's BAM; range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.growth = Synthetic::Growth::kFirstAndSecond},
    .exports = inAllFormats(lost(exports::kNoFrictionOfLoad)),
    .other_names = kOtherNames,
    .make = makeEffect<DirectionalLoadFriction>,
}};

}  // namespace darwinop::twin
