// Effect: scale error of the goal, from another gear ratio or a wrong number of ticks per turn.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kGearScale;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "scale",
              .unit = "",
              .meaning = "angle reached per angle commanded",
              .low = 0.85,
              .high = 1.15,
              .neutral = 1,
              .typical = 0.95,
              .role = ParameterRole::kGoalFactor,
              .error_scale = ErrorScale::kFromOne},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"encoder_offset", "com_mass", "kp_scale"});
constexpr std::string_view kInController = "multiply the goal in the controller";
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kLoadColumn, LogFeature::kBothSides});
constexpr auto kOtherNames = std::to_array<OtherName>({{"gear_scale", "scale"}, {"s", "scale"}});

class GearScale final : public EffectOf<kGearScale, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kCommandHook; }
  void command(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [scale] = values_;
    s.goal_rad *= scale;
  }
};

}  // namespace

const EffectInfo kGearScale{{
    .id = "gear_scale",
    .title = "goal scale error",
    .part = LoopPart::kController,
    .equation = "goal = scale * goal",
    .signature = "Error proportional to the goal, at every P gain, also at rest without load.",
    .separated_by =
        "Hold at +1 and -1 rad without load: a scale error has opposite signs on the two sides, an offset the same.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.pair_rank = 12},
    .exports = {.webots = lost(kInController),
                .mujoco = held("gainprm, the goal's factor"),
                .urdf = lost(kInController)},
    .other_names = kOtherNames,
    .make = makeEffect<GearScale>,
}};

}  // namespace darwinop::twin
