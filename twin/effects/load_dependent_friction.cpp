// Gears that rub the more, the more torque goes through them.
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

const EffectInfo kLoadDependentFriction{
    .id = "load_dependent_friction",
    .title = "load-dependent friction",
    .place = Place::kFriction,
    .equation = "F += share |tm - te|",
    .signature = "Stops short on the side it comes from, by an amount that grows with the payload.",
    .separated_by =
        "The same trajectory at three payloads: dry friction stays constant, this one grows. One payload is not "
        "enough.",
    .source = "Rhoban's BAM; range assumed. Holding 1 N m puts 2 N m between motor and load.",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<LoadDependentFriction>,
};

}  // namespace darwinop::twin
