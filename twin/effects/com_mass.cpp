// Effect: error of the load's mass or centre of mass.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kComMass;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "mass",
              .unit = "",
              .meaning = "relative change of the mass: of the link, on a bench of all that the joint carries",
              .low = -0.4,
              .high = 0.4,
              .neutral = 0,
              .typical = 0.08,
              .role = ParameterRole::kLoadMass},
    Parameter{.key = "shift",
              .unit = "m",
              .meaning = "distance of the centre of mass outwards",
              .low = -0.05,
              .high = 0.05,
              .neutral = 0,
              .typical = 0,
              .role = ParameterRole::kLoadShift},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"encoder_offset", "kt_error", "kp_scale", "gear_scale", "inertia", "coulomb"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kPayloads, LogFeature::kBothSides});
constexpr auto kAliases =
    std::to_array<BaselineAlias>({{.number = "payload", .relation = BaselineAlias::Relation::kRelativeChange},
                                  {.number = "length", .relation = BaselineAlias::Relation::kAdded, .parameter = 1}});
constexpr auto kOtherNames = std::to_array<OtherName>({{"m_fac", "mass", 1}, {"com_shift", "shift"}});

class ComMass final : public EffectOf<kComMass, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kLoadHook; }
  void load(LoadChange& change) noexcept override {
    const auto& [mass, shift] = values_;
    change.mass_scale *= 1 + mass;
    change.com_shift_m += shift;
  }
};

}  // namespace

const EffectInfo kComMass{{
    .id = "com_mass",
    .title = "load mass error",
    .part = LoopPart::kLoad,
    .equation = "m = m (1 + mass); L = L + shift",
    .signature = "Stops short in proportion to the sine of the angle; the swing period differs.",
    .separated_by =
        "Holds at +90 and -90 degrees (a zero error shows as a difference); swing period with a known extra mass.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = kAliases,
    .step_demand = StepDemand::kNone,
    .synthetic = {.growth = Synthetic::Growth::kFirstOrSecond, .pair_rank = 15},
    .exports = inAllFormats(held(exports::kInTheBody)),
    .other_names = kOtherNames,
    .make = makeEffect<ComMass>,
}};

}  // namespace darwinop::twin
