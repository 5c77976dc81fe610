// Effect: viscous friction, proportional to speed.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kViscous;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "damping",
              .unit = "N m s/rad",
              .meaning = "friction per speed of the joint",
              .low = 0,
              .high = 0.2,
              .neutral = 0,
              .typical = 0.01,
              .logarithmic = true,
              .role = ParameterRole::kViscousFriction},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"kt_error", "coulomb", "transport_delay"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kTorqueOff});
constexpr auto kAliases = std::to_array<BaselineAlias>(
    {{.number = "viscous.damping", .relation = BaselineAlias::Relation::kOwnValue, .case_key = "viscous_Nms_rad"}});
constexpr auto kOtherNames = std::to_array<OtherName>({{"kv", "damping"}});

class Viscous final : public EffectOf<kViscous, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [damping] = values_;
    s.damping_nms_rad += damping;
  }
};

}  // namespace

const EffectInfo kViscous{{
    .id = "viscous",
    .title = "viscous friction",
    .part = LoopPart::kFriction,
    .equation = "F += damping |w|",
    .signature = "Error proportional to speed; a released swing decays exponentially.",
    .separated_by = "Swing with torque off (no back EMF) against powered motion at constant speed.",
    .source = "2013 thesis 5.3.2: 0.002 N m s/rad",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kCommon,
    .aliases = kAliases,
    .step_demand = StepDemand::kNone,
    .synthetic = {.pair_rank = 5},
    .exports = {.webots =
                    approximated("dampingConstant: brakes the limp joint; a motor driven by speed shows none of it"),
                .mujoco = held("damping"),
                .urdf = held("dynamics damping")},
    .other_names = kOtherNames,
    .make = makeEffect<Viscous>,
}};

}  // namespace darwinop::twin
