// Effect that only this test program has: a spring that pulls the joint back to its zero. All of it is in this file.
#include "twin/effects/catalogue.hpp"

namespace darwinop::twin {

extern const EffectInfo kReturnSpring;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "stiffness",
              .unit = "N m/rad",
              .meaning = "torque towards zero per angle",
              .low = 0,
              .high = 1,
              .neutral = 0,
              .typical = 0.2,
              .logarithmic = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"com_mass"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kPayloads});

class ReturnSpring final : public EffectOf<kReturnSpring, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [stiffness] = values_;
    s.extra_torque_nm -= stiffness * s.position_rad;
  }
};

}  // namespace

const EffectInfo kReturnSpring{{
    .id = "return_spring",
    .title = "return spring",
    .part = LoopPart::kLoad,
    .equation = "tm = tm - stiffness q",
    .signature = "Stops short in proportion to the angle, at any payload.",
    .separated_by = "Hold at one angle with two payloads: the spring's share does not grow.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {},
    .exports = inAllFormats(lost("no torque of a joint depends on its angle alone")),
    .other_names = {},
    .make = makeEffect<ReturnSpring>,
}};

std::span<const EffectInfo* const> addedEffects() {
  static constexpr std::array kAdded{&kReturnSpring};
  return kAdded;
}

}  // namespace darwinop::twin
