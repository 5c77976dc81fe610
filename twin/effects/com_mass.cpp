// What the joint carries is heavier than the model says, or its centre of mass is further out.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kComMass;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "mass",
              .unit = "",
              .meaning = "relative change of the mass",
              .low = -0.4,
              .high = 0.4,
              .neutral = 0,
              .typical = 0.08},
    Parameter{.key = "shift",
              .unit = "m",
              .meaning = "distance of the centre of mass outwards",
              .low = -0.05,
              .high = 0.05,
              .neutral = 0,
              .typical = 0},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"encoder_offset", "kt_error", "kp_scale", "gear_scale", "inertia", "coulomb"});

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

const EffectInfo kComMass{
    .id = "com_mass",
    .title = "load mass error",
    .place = Place::kLoad,
    .equation = "m = m (1 + mass); L = L + shift",
    .signature = "Stops short in proportion to the sine of the angle; the swing period differs.",
    .separated_by =
        "Holds at +90 and -90 degrees (a zero error shows as a difference); swing period with a known extra mass. Only "
        "inertia against gravity separates mass from distance.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<ComMass>,
};

}  // namespace darwinop::twin
