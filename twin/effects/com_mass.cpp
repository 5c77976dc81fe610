// What the joint carries is heavier than the model says, or its centre of mass is further out.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kComMass;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "mass",
              .unit = "",
              .meaning = "share by which the mass is larger",
              .low = -0.4,
              .high = 0.4,
              .neutral = 0,
              .typical = 0.08},
    Parameter{.key = "shift",
              .unit = "m",
              .meaning = "how much further out the centre of mass is",
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
    .title = "mass of the load off",
    .place = Place::kLoad,
    .equation = "m = m (1 + mass); L = L + shift",
    .signature = "Stops short by an amount that goes with the sine of the angle; the swing has another period.",
    .separated_by =
        "Holds at +90 and -90 degrees (an offset of the zero shows as a difference), and the swing period with a known "
        "extra mass. Only inertia against gravity tells mass from distance.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<ComMass>,
};

}  // namespace darwinop::twin
