// Effect: error of the rotor and gear inertia; gravity is unchanged.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kInertia;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "change",
              .unit = "kg m2",
              .meaning = "added to the armature, as seen at the horn",
              .low = -0.0015,
              .high = 0.0015,
              .neutral = 0,
              .typical = 0.0005},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"transport_delay", "accel_limit", "joint_flex", "com_mass"});
constexpr auto kAliases =
    std::to_array<BaselineAlias>({{.number = "armature", .relation = BaselineAlias::Relation::kAdded}});

class Inertia final : public EffectOf<kInertia, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kLoadHook; }
  void load(LoadChange& change) noexcept override { change.armature_kgm2 += values_[0]; }
};

}  // namespace

const EffectInfo kInertia{{
    .id = "inertia",
    .title = "rotor and gear inertia error",
    .part = LoopPart::kLoad,
    .equation = "J = J + change",
    .signature = "Fast motion only: the first 100 ms of a step, the amplitude of a chirp above 2 Hz.",
    .separated_by = "Chirp with and without payload: the armature matters more when the arm is light.",
    .source = "Half of the 0.003 kg m2 found on benches",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = {},
    .prevalence = Prevalence::kRare,
    .aliases = kAliases,
    .step_demand = StepDemand::kNone,
    .synthetic = {},
    .exports = {.webots = approximated(exports::kInTheLink),
                .mujoco = held("armature"),
                .urdf = approximated(exports::kInTheLink)},
    .other_names = {},
    .make = makeEffect<Inertia>,
}};

}  // namespace darwinop::twin
