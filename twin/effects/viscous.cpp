// Friction in proportion to speed.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kViscous;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "damping",
              .unit = "N m s/rad",
              .meaning = "friction per speed of the joint",
              .low = 0,
              .high = 0.2,
              .neutral = 0,
              .typical = 0.01,
              .logarithmic = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"kt_error", "coulomb", "transport_delay"});

class Viscous final : public EffectOf<kViscous, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [damping] = values_;
    s.damping_nms_rad += damping;
  }
};

}  // namespace

const EffectInfo kViscous{
    .id = "viscous",
    .title = "viscous friction",
    .place = Place::kFriction,
    .equation = "F += damping |w|",
    .signature = "Error proportional to speed; a released swing decays exponentially.",
    .separated_by = "Swing with torque off (no back EMF) against powered motion at constant speed.",
    .source = "2013 thesis 5.3.2: 0.002 N m s/rad, with dry friction of 0.025 N m",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<Viscous>,
};

}  // namespace darwinop::twin
