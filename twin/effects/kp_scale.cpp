// Effect: scale error of the P gain.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kKpScale;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "scale",
              .unit = "",
              .meaning = "real gain over register gain",
              .low = 0.2,
              .high = 4,
              .neutral = 1,
              .typical = 1.2,
              .logarithmic = true,
              .role = ParameterRole::kGainFactor,
              .error_scale = ErrorScale::kFromOne},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"resistance_error", "supply_sag", "gear_scale", "deadband"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kLoadColumn, LogFeature::kGains});
constexpr auto kAliases =
    std::to_array<BaselineAlias>({{.number = "duty_per_kp", .relation = BaselineAlias::Relation::kFactor}});
constexpr auto kOtherNames = std::to_array<OtherName>({{"kp_fac", "scale"}});

class KpScale final : public EffectOf<kKpScale, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kControllerHook; }
  void controller(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [scale] = values_;
    s.p_register *= scale;
  }
};

}  // namespace

const EffectInfo kKpScale{{
    .id = "kp_scale",
    .title = "P gain scale error",
    .part = LoopPart::kController,
    .equation = "u = scale K P e",
    .signature = "Stops short by the same factor at every load.",
    .separated_by = "The slope of load against error shows it from the log alone, without any mechanics.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = kAliases,
    .step_demand = StepDemand::kNone,
    .synthetic = {.pair_rank = 17},
    .exports = {.webots = approximated("controlPID, P of a speed"),
                .mujoco = held("actuator: gainprm and biasprm"),
                .urdf = lost(exports::kNoController)},
    .other_names = kOtherNames,
    .make = makeEffect<KpScale>,
}};

}  // namespace darwinop::twin
