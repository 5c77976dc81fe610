// Effect: Stribeck friction, extra dry friction that decays with speed.
#include <cmath>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kStribeck;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "friction",
              .unit = "N m",
              .meaning = "extra friction at rest",
              .low = 0,
              .high = 0.3,
              .neutral = 0,
              .typical = 0.05,
              .logarithmic = true},
    Parameter{.key = "speed",
              .unit = "rad/s",
              .meaning = "where it has faded to 37 %",
              .low = 0.05,
              .high = 3,
              .neutral = 0.2,
              .typical = 0.2,
              .logarithmic = true},
    Parameter{.key = "exponent",
              .unit = "",
              .meaning = "how sharply it fades",
              .low = 0.8,
              .high = 3,
              .neutral = 1,
              .typical = 1,
              .secondary = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"coulomb", "cogging"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kSlowMotion});
constexpr auto kDrawn = std::to_array<DrawnParameter>({{.parameter = 1, .low = 0.1, .high = 0.3}});
constexpr auto kOtherNames = std::to_array<OtherName>({{"Fs", "friction"}, {"ws", "speed"}, {"a", "exponent"}});

class Stribeck final : public EffectOf<kStribeck, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [friction, speed, exponent] = values_;
    const double ratio = std::abs(s.velocity_rad_s) / speed;
    s.dry_friction_nm += friction * std::exp(-(exponent == 1 ? ratio : std::pow(ratio, exponent)));
  }
};

}  // namespace

const EffectInfo kStribeck{{
    .id = "stribeck",
    .title = "Stribeck friction at low speed",
    .part = LoopPart::kFriction,
    .equation = "F += friction exp(-(|w| / speed)^exponent)",
    .signature = "Stick-slip in slow moves, no change in fast ones.",
    .separated_by = "Triangle at 0.05, 0.2 and 1 rad/s: the extra friction fades with speed, dry friction does not.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.drawn = kDrawn, .pair_rank = 6},
    .exports = inAllFormats(lost("its dry friction is the same at every speed")),
    .other_names = kOtherNames,
    .make = makeEffect<Stribeck>,
}};

}  // namespace darwinop::twin
