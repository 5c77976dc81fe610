// The joint goes to a multiple of the goal: another gear, or a wrong number of ticks per turn.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kGearScale;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "scale",
              .unit = "",
              .meaning = "angle reached per angle asked for",
              .low = 0.85,
              .high = 1.15,
              .neutral = 1,
              .typical = 0.95},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"encoder_offset", "com_mass", "kp_scale"});

class GearScale final : public EffectOf<kGearScale, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kCommandHook; }
  void command(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [scale] = values_;
    s.goal_rad *= scale;
  }
};

}  // namespace

const EffectInfo kGearScale{
    .id = "gear_scale",
    .title = "scale of the goal",
    .place = Place::kController,
    .equation = "goal = scale * goal",
    .signature = "Error in proportion to the goal, at rest and without load too, at every P gain.",
    .separated_by =
        "Hold at +1 and -1 rad without load: a scale errs outward or inward on both sides, an offset the same way on "
        "both.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<GearScale>,
};

}  // namespace darwinop::twin
