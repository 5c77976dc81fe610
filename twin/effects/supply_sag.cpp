// Effect: voltage drop over battery and cable resistance, and discharge over the session.
#include <algorithm>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kSupplySag;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "resistance",
              .unit = "ohm",
              .meaning = "of battery and cables",
              .low = 0,
              .high = 4,
              .neutral = 0,
              .typical = 0.5,
              .logarithmic = true,
              .role = ParameterRole::kSupplyResistance},
    Parameter{.key = "droop",
              .unit = "V/s",
              .meaning = "loss of voltage over the session",
              .low = 0,
              .high = 0.01,
              .neutral = 0,
              .typical = 0,
              .secondary = true},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"torque_limit", "speed_limit", "resistance_error", "kt_error", "kp_scale"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kVoltageColumn});
constexpr auto kOtherNames = std::to_array<OtherName>({{"Rs", "resistance"}});

class SupplySag final : public EffectOf<kSupplySag, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMotorHook; }
  // Solves for the current implicitly, because it depends on the voltage; an explicit step would oscillate.
  void motor(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [resistance, droop] = values_;
    const double battery_v = std::max(0.0, s.supply_v - droop * s.session_time_s);
    const double current =
        (s.duty * battery_v - s.back_emf_vs_rad * s.velocity_rad_s) / (s.resistance_ohm + resistance * s.duty * s.duty);
    const double max_current = s.torque_limit_nm / s.kt_nm_a;
    s.supply_v = battery_v - resistance * s.duty * std::clamp(current, -max_current, max_current);
  }
};

}  // namespace

const EffectInfo kSupplySag{{
    .id = "supply_sag",
    .title = "supply voltage sag",
    .part = LoopPart::kSupply,
    .equation = "V = V0 - resistance u i - droop t",
    .signature = "The voltage dips with the square of the load; top speed and torque fall with it.",
    .separated_by = "Log the voltage; make the same move without payload and with the largest.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kVoltageP,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.pair_rank = 16},
    .exports = inAllFormats(lost("it has no supply voltage")),
    .other_names = kOtherNames,
    .make = makeEffect<SupplySag>,
}};

}  // namespace darwinop::twin
