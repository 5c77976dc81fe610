// Dry friction: the same torque against every motion, and against the start of one.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kCoulomb;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "friction",
              .unit = "N m",
              .meaning = "torque that holds a resting joint and brakes a moving one",
              .low = 0,
              .high = 0.3,
              .neutral = 0,
              .typical = 0.05,
              .logarithmic = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"deadband", "viscous", "backlash", "stribeck"});

class Coulomb final : public EffectOf<kCoulomb, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [friction] = values_;
    s.dry_friction_nm += friction;
  }
};

}  // namespace

const EffectInfo kCoulomb{
    .id = "coulomb",
    .title = "dry friction",
    .place = Place::kFriction,
    .equation = "F += friction",
    .signature =
        "Stops short of the goal on the side it comes from; a released swing decays linearly and may rest away from "
        "the lowest point.",
    .separated_by =
        "Slow triangle both ways at two P gains: for friction, offset times gain is constant. A swing with torque off "
        "shows it without the controller.",
    .source = "2013 thesis 5.3.2: 0.025 N m, with viscous friction of 0.002 N m s/rad",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<Coulomb>,
};

}  // namespace darwinop::twin
