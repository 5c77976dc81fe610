// Effect: gear friction quadratic in motor and load torque.
#include <cmath>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kQuadraticLoadFriction;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "motor",
              .unit = "1/(N m)",
              .meaning = "friction per square of the torque of the motor",
              .low = 0,
              .high = 2,
              .neutral = 0,
              .typical = 0.005,
              .logarithmic = true},
    Parameter{.key = "load",
              .unit = "1/(N m)",
              .meaning = "friction per square of the torque of the load",
              .low = 0,
              .high = 2,
              .neutral = 0,
              .typical = 0,
              .logarithmic = true},
    Parameter{.key = "fade_speed",
              .unit = "rad/s",
              .meaning = "where it has faded to 37 %",
              .low = 0.05,
              .high = 1000,
              .neutral = 1000,
              .typical = 1000,
              .logarithmic = true,
              .secondary = true},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"directional_load_friction", "load_dependent_friction", "torque_limit"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kPayloads});
constexpr auto kOtherNames = std::to_array<OtherName>({{"Kq", "motor"}, {"K", "motor"}});

class QuadraticLoadFriction final : public EffectOf<kQuadraticLoadFriction, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [motor, load, fade_speed] = values_;
    const double friction = motor * s.motor_torque_nm * s.motor_torque_nm +  //
                            load * s.external_torque_nm * s.external_torque_nm;
    s.dry_friction_nm += friction * std::exp(-std::abs(s.velocity_rad_s) / fade_speed);
  }
};

}  // namespace

const EffectInfo kQuadraticLoadFriction{{
    .id = "quadratic_load_friction",
    .title = "friction quadratic in the load",
    .part = LoopPart::kFriction,
    .equation = "F += (motor tm^2 + load te^2) exp(-|w| / fade_speed)",
    .signature = "Only at the largest loads: a few milliradians on an MX servo, stuck lifts on a small gear.",
    .separated_by =
        "Lift growing payloads up to full duty: this friction keeps growing, a torque limit stops at one torque.",
    .source = "Rhoban's BAM, up to 0.01 and 2.4 mrad on an MX servo; 0.3 to 0.7 fits a gear at its limit",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.growth = Synthetic::Growth::kFirstAndSecond, .most_severe = 1},
    .exports = inAllFormats(lost(exports::kNoFrictionOfLoad)),
    .other_names = kOtherNames,
    .make = makeEffect<QuadraticLoadFriction>,
}};

}  // namespace darwinop::twin
