// Effect: backlash between gears and horn. The encoder sits on the horn.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kBacklash;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "play",
              .unit = "rad",
              .meaning = "total gap, from one flank to the other",
              .low = 0,
              .high = 0.06,
              .neutral = 0,
              .typical = 0.0058,
              .logarithmic = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"deadband", "coulomb", "joint_flex", "encoder_offset"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kBothSides});
constexpr auto kOtherNames = std::to_array<OtherName>({{"backlash", "play"}, {"b", "play"}});

class Backlash final : public EffectOf<kBacklash, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [play] = values_;
    s.backlash_rad = play;
  }
};

}  // namespace

const EffectInfo kBacklash{{
    .id = "backlash",
    .title = "gear backlash",
    .part = LoopPart::kTransmission,
    .equation = "no torque between gears and horn while |q_gears - q_horn| < play / 2",
    .signature = "Free motion and hunting where the load changes sign; an irregular first swing after a release.",
    .separated_by = "Hold where gravity pulls either way and not at all; small sine around hanging and at 60 degrees.",
    .source = "MX-28: 20 arcmin; range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kSoftGear,
    .synthetic = {.pair_rank = 8},
    .exports = {.webots = approximated(
                    "HingeJointWithBacklash, gap: hard stops; the sensor sits before the gap, the servo's behind it"),
                .mujoco =
                    approximated("a second hinge with a range: soft stops; the actuator sees the angle before the gap"),
                .urdf = lost("one joint has no play; it would take a second one with limits, which many readers drop")},
    .other_names = kOtherNames,
    .make = makeEffect<Backlash>,
}};

}  // namespace darwinop::twin
