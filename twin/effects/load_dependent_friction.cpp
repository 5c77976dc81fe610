// Effect: gear friction proportional to the transmitted torque.
#include <cmath>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kLoadDependentFriction;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "share",
              .unit = "",
              .meaning = "friction per torque between motor and load",
              .low = 0,
              .high = 0.4,
              .neutral = 0,
              .typical = 0.05,
              .logarithmic = true},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"coulomb", "kt_error", "directional_load_friction", "quadratic_load_friction"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kPayloads});
constexpr auto kOtherNames = std::to_array<OtherName>({{"Kl", "share"}, {"kl", "share"}, {"K_load", "share"}});

class LoadDependentFriction final : public EffectOf<kLoadDependentFriction, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [share] = values_;
    s.dry_friction_nm += share * std::abs(s.motor_torque_nm - s.external_torque_nm);
  }
};

}  // namespace

const EffectInfo kLoadDependentFriction{{
    .id = "load_dependent_friction",
    .title = "load-dependent friction",
    .part = LoopPart::kFriction,
    .equation = "F += share |tm - te|",
    .signature = "Stops short on the side it comes from, by an amount that grows with the payload.",
    .separated_by = "Three payloads: dry friction stays constant, this one grows.",
    .source = "Rhoban's BAM; range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kCommon,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.pair_rank = 7},
    .exports = inAllFormats(lost(exports::kNoFrictionOfLoad)),
    .other_names = kOtherNames,
    .make = makeEffect<LoadDependentFriction>,
}};

}  // namespace darwinop::twin
