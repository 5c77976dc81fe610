// Effect: Coulomb (dry) friction, the same torque at rest and in motion.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kCoulomb;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "friction",
              .unit = "N m",
              .meaning = "torque that holds a resting joint and brakes a moving one",
              .low = 0,
              .high = 0.4,
              .neutral = 0,
              .typical = 0.05,
              .logarithmic = true,
              .role = ParameterRole::kDryFriction},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"deadband", "viscous", "backlash", "stribeck"});
constexpr auto kRevealedBy =
    std::to_array<LogFeature>({LogFeature::kTorqueOff, LogFeature::kPayloads, LogFeature::kGains});
constexpr auto kAliases = std::to_array<BaselineAlias>(
    {{.number = "coulomb.friction", .relation = BaselineAlias::Relation::kOwnValue, .case_key = "coulomb_Nm"}});
constexpr auto kOtherNames = std::to_array<OtherName>({{"Fc", "friction"}});

class Coulomb final : public EffectOf<kCoulomb, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [friction] = values_;
    s.dry_friction_nm += friction;
  }
};

}  // namespace

const EffectInfo kCoulomb{{
    .id = "coulomb",
    .title = "dry friction",
    .part = LoopPart::kFriction,
    .equation = "F += friction",
    .signature =
        "Stops short of the goal on the side it comes from; a released swing decays linearly and may rest away from "
        "the lowest point.",
    .separated_by =
        "Slow triangle at two P gains: offset times gain is constant. A swing with torque off shows it without the "
        "controller.",
    .source = "2013 thesis 5.3.2: 0.025 N m",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kCommon,
    .aliases = kAliases,
    .step_demand = StepDemand::kNone,
    .synthetic = {.pair_rank = 4},
    .exports = {.webots = approximated(
                    "staticFriction: brakes and holds the limp joint; a motor driven by speed shows none of it"),
                .mujoco = held("frictionloss"),
                .urdf = held("dynamics friction")},
    .other_names = kOtherNames,
    .make = makeEffect<Coulomb>,
}};

}  // namespace darwinop::twin
