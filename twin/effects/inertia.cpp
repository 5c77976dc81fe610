// Rotor and gears that are harder, or easier, to accelerate than the model says. Gravity does not notice.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kInertia;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "change",
              .unit = "kg m2",
              .meaning = "added to the armature, as seen at the horn",
              .low = -0.0015,
              .high = 0.0015,
              .neutral = 0,
              .typical = 0.0005},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"transport_delay", "accel_limit", "joint_flex", "com_mass"});

class Inertia final : public EffectOf<kInertia, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kLoadHook; }
  void load(LoadChange& change) noexcept override { change.armature_kgm2 += values_[0]; }
};

}  // namespace

const EffectInfo kInertia{
    .id = "inertia",
    .title = "rotor and gear inertia error",
    .place = Place::kLoad,
    .equation = "J = J + change",
    .signature = "Fast motion only: the first 100 ms of a step, the amplitude of a chirp above 2 Hz.",
    .separated_by = "Chirp with and without payload: the armature matters more when the arm is light.",
    .source = "Half of the 0.003 kg m2 found on benches of this servo family",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<Inertia>,
};

}  // namespace darwinop::twin
