// Effect: torque ripple as a function of angle, from motor cogging or an eccentric gear.
#include <cmath>

#include "core/units.hpp"
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kCogging;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "amplitude",
              .unit = "N m",
              .meaning = "of the ripple, at the horn",
              .low = 0,
              .high = 0.15,
              .neutral = 0,
              .typical = 0.03,
              .logarithmic = true,
              .role = ParameterRole::kRippleTorque},
    Parameter{.key = "count",
              .unit = "",
              .meaning = "ripples per turn of the horn; 1 and 2: an eccentric wheel",
              .low = 1,
              .high = 60,
              .neutral = 24,
              .typical = 24},
    Parameter{.key = "phase",
              .unit = "rad",
              .meaning = "of the ripple at angle 0",
              .low = -3.15,
              .high = 3.15,
              .neutral = 0,
              .typical = 0,
              .error_scale = ErrorScale::kNone},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"stribeck", "joint_flex"});
constexpr std::array kCounts{12.0, 16.0, 20.0, 24.0, 30.0, 36.0};  // a turn
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kSlowMotion});
constexpr auto kDrawn = std::to_array<DrawnParameter>(
    {{.parameter = 1, .low = 12, .high = 36, .choices = kCounts}, {.parameter = 2, .low = -kPi, .high = kPi}});
constexpr auto kOtherNames =
    std::to_array<OtherName>({{"cog_A", "amplitude"}, {"cog_N", "count"}, {"cog_phi", "phase"}});

class Cogging final : public EffectOf<kCogging, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [amplitude, count, phase] = values_;
    s.extra_torque_nm += amplitude * std::sin(count * s.position_rad + phase);
  }
};

}  // namespace

const EffectInfo kCogging{{
    .id = "cogging",
    .title = "torque ripple",
    .part = LoopPart::kMotor,
    .equation = "tm = tm + amplitude sin(count q + phase)",
    .signature = "Position ripple locked to the angle, the same at all speeds.",
    .separated_by = "Slow triangle at two speeds: the ripple keeps its angle.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.drawn = kDrawn, .pair_rank = 13},
    .exports = {.webots = lost("no joint has a periodic torque; add it in a physics plug-in"),
                .mujoco = lost("no joint has a periodic torque; add it as qfrc_applied"),
                .urdf = lost("no joint has a periodic torque")},
    .other_names = kOtherNames,
    .make = makeEffect<Cogging>,
}};

}  // namespace darwinop::twin
