// Effect: error of the winding resistance.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kResistanceError;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "change",
              .unit = "",
              .meaning = "relative change of the resistance",
              .low = -0.15,
              .high = 0.15,
              .neutral = 0,
              .typical = 0.05},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"kt_error", "kp_scale", "supply_sag"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kVoltageColumn, LogFeature::kGains});
constexpr auto kAliases =
    std::to_array<BaselineAlias>({{.number = "resistance", .relation = BaselineAlias::Relation::kRelativeChange}});
constexpr auto kOtherNames = std::to_array<OtherName>({{"R_fac", "change", 1}});

class ResistanceError final : public EffectOf<kResistanceError, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMotorHook; }
  void motor(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [change] = values_;
    s.resistance_ohm *= 1 + change;
  }
};

}  // namespace

const EffectInfo kResistanceError{{
    .id = "resistance_error",
    .title = "winding resistance error",
    .part = LoopPart::kMotor,
    .equation = "R = R (1 + change)",
    .signature = "All motor torque scales; a load needs a different duty than the model predicts.",
    .separated_by = "Hold a known payload and read the load; repeat with the servo warm (copper: 0.39 % per kelvin).",
    .source = "Stall current 1.4 A at 12 V includes cables and bridge; range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kVoltageP,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = kAliases,
    .step_demand = StepDemand::kNone,
    .synthetic = {},
    .exports = {.webots = approximated("maxTorque"),
                .mujoco = held("actuator: kp, forcerange and the back EMF's biasprm"),
                .urdf = approximated("limit effort")},
    .other_names = kOtherNames,
    .make = makeEffect<ResistanceError>,
}};

}  // namespace darwinop::twin
