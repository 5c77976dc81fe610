// Effect: angle offset of gravity, from an encoder zero error, a tilted base or a lateral mass.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kEncoderOffset;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "offset",
              .unit = "rad",
              .meaning = "reading where the arm hangs straight down",
              .low = -0.15,
              .high = 0.15,
              .neutral = 0,
              .typical = 0.03},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"com_mass", "gear_scale", "backlash"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kBothSides});
constexpr auto kOtherNames = std::to_array<OtherName>({{"zero_off", "offset"}, {"o", "offset"}});

class EncoderOffset final : public EffectOf<kEncoderOffset, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kLoadHook; }
  void load(LoadChange& change) noexcept override {
    const auto& [offset] = values_;
    change.angle_offset_rad += offset;
  }
};

}  // namespace

const EffectInfo kEncoderOffset{{
    .id = "encoder_offset",
    .title = "encoder zero error",
    .part = LoopPart::kLoad,
    .equation = "te(q) = te(q - offset)",
    .signature = "Rests away from 0 after a release; stops short by different amounts left and right.",
    .separated_by = "Turn the base by 180 degrees or weigh the arm.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kCommon,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.pair_rank = 11},
    .exports = inAllFormats(held("in the body: the link turned about its joint by the offset")),
    .other_names = kOtherNames,
    .make = makeEffect<EncoderOffset>,
}};

}  // namespace darwinop::twin
