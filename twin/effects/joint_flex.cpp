// Effect: elastic joint, a spring and damper between horn and arm.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kJointFlex;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "stiffness",
              .unit = "N m/rad",
              .meaning = "of the spring",
              .low = 2,
              .high = 1000,
              .neutral = 1000,
              .typical = 50,
              .logarithmic = true},
    Parameter{.key = "damping",
              .unit = "N m s/rad",
              .meaning = "of the spring",
              .low = 0,
              .high = 0.5,
              .neutral = 0.01,
              .typical = 0.01,
              .logarithmic = true,
              .secondary = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"backlash", "transport_delay", "cogging", "inertia"});
constexpr auto kOtherNames =
    std::to_array<OtherName>({{"flex_k", "stiffness"}, {"k", "stiffness"}, {"flex_c", "damping"}, {"c", "damping"}});

class JointFlex final : public EffectOf<kJointFlex, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [stiffness, damping] = values_;
    if (stiffness >= kParameters[0].neutral) return;
    s.flex_stiffness_nm_rad = stiffness;
    s.flex_damping_nms_rad = damping;
  }
};

}  // namespace

const EffectInfo kJointFlex{{
    .id = "joint_flex",
    .title = "elastic joint",
    .part = LoopPart::kTransmission,
    .equation = "t = stiffness (q_gears - q_horn) + damping (w_gears - w_horn)",
    .signature = "Rings after steps, at a frequency that falls with the payload.",
    .separated_by = "Tap the arm with two payloads: the frequency is proportional to 1/sqrt(inertia).",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = {},
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kSoftGear,
    .synthetic = {.pair_rank = 14},
    .exports = {.webots = lost(
                    "it would take a second hinge with a springConstant, which steps of 8 and 16 ms cannot follow"),
                .mujoco = held("a second hinge: stiffness and damping"),
                .urdf = lost("a joint has no stiffness")},
    .other_names = kOtherNames,
    .make = makeEffect<JointFlex>,
}};

}  // namespace darwinop::twin
