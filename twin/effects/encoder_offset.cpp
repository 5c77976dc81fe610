// Gravity pulls as if the joint stood elsewhere: the zero of the encoder, a base that tilts, a mass off the middle
// line.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kEncoderOffset;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "offset",
              .unit = "rad",
              .meaning = "reading of the encoder where the arm hangs straight down",
              .low = -0.15,
              .high = 0.15,
              .neutral = 0,
              .typical = 0.03},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"com_mass", "gear_scale", "backlash"});

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

const EffectInfo kEncoderOffset{
    .id = "encoder_offset",
    .title = "encoder zero error",
    .place = Place::kLoad,
    .equation = "te(q) = te(q - offset)",
    .signature = "Rests away from 0 after a release; stops short by different amounts left and right.",
    .separated_by =
        "Turn the base by 180 degrees or weigh the arm: for one link, tilt and lateral mass have the same equation.",
    .source = "Range assumed; a horn slipped by one tooth is far outside it",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<EncoderOffset>,
};

}  // namespace darwinop::twin
