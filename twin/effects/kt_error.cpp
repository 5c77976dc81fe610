// Effect: error of the torque constant; the back EMF changes with it.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kKtError;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "change",
              .unit = "",
              .meaning = "relative change of torque constant and back EMF",
              .low = -0.1,
              .high = 0.1,
              .neutral = 0,
              .typical = 0.05},
    Parameter{.key = "back_emf",
              .unit = "",
              .meaning = "further relative change of the back EMF alone",
              .low = -0.2,
              .high = 0.2,
              .neutral = 0,
              .typical = 0,
              .secondary = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>(
    {"viscous", "resistance_error", "speed_limit", "supply_sag", "load_dependent_friction", "com_mass"});
constexpr auto kRevealedBy =
    std::to_array<LogFeature>({LogFeature::kVoltageColumn, LogFeature::kTorqueOff, LogFeature::kFastMotion});
constexpr auto kAliases = std::to_array<BaselineAlias>(
    {{.number = "kt", .relation = BaselineAlias::Relation::kRelativeChange, .with = "back_emf"}});
constexpr auto kOtherNames = std::to_array<OtherName>({{"kt_fac", "change", 1}});

class KtError final : public EffectOf<kKtError, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMotorHook; }
  void motor(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [change, back_emf] = values_;
    s.kt_nm_a *= 1 + change;
    s.back_emf_vs_rad *= (1 + change) * (1 + back_emf);
  }
};

}  // namespace

const EffectInfo kKtError{{
    .id = "kt_error",
    .title = "torque constant error",
    .part = LoopPart::kMotor,
    .equation = "kt = kt (1 + change); ke = ke (1 + change) (1 + back_emf)",
    .signature = "Error proportional to speed, only with torque on; a different top speed.",
    .separated_by =
        "Swing with torque off against powered motion at constant speed: back EMF brakes only with the bridge on.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kVoltageP,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = kAliases,
    .step_demand = StepDemand::kNone,
    .synthetic = {},
    .exports = {.webots = approximated("maxTorque, maxVelocity and P"),
                .mujoco = held("actuator: kp, forcerange and the back EMF's biasprm"),
                .urdf = approximated("limit effort and velocity")},
    .other_names = kOtherNames,
    .make = makeEffect<KtError>,
}};

}  // namespace darwinop::twin
