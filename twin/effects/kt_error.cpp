// A motor that is stronger or weaker than its data sheet: torque per current and back EMF go together.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kKtError;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "change",
              .unit = "",
              .meaning = "relative change of torque constant and back EMF",
              .low = -0.1,
              .high = 0.1,
              .neutral = 0,
              .typical = 0.05},
    Parameter{.key = "back_emf",
              .unit = "",
              .meaning = "further relative change of the back EMF alone",
              .low = -0.2,
              .high = 0.2,
              .neutral = 0,
              .typical = 0,
              .secondary = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>(
    {"viscous", "resistance_error", "speed_limit", "supply_sag", "load_dependent_friction", "com_mass"});

class KtError final : public EffectOf<kKtError, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMotorHook; }
  void motor(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [change, back_emf] = values_;
    s.kt_nm_a *= 1 + change;
    s.back_emf_vs_rad *= (1 + change) * (1 + back_emf);
  }
};

}  // namespace

const EffectInfo kKtError{
    .id = "kt_error",
    .title = "torque constant error",
    .place = Place::kMotor,
    .equation = "kt = kt (1 + change); ke = ke (1 + change) (1 + back_emf)",
    .signature = "Error proportional to speed, only with torque on; a different top speed.",
    .separated_by =
        "Swing with torque off against powered motion at constant speed: back EMF brakes only with the bridge on.",
    .source = "Magnets differ by some per cent between units; range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<KtError>,
};

}  // namespace darwinop::twin
