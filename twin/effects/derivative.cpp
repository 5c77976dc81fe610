// Effect: derivative gain in the position law.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kDerivative;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "gain",
              .unit = "s",
              .meaning = "Kd of the manual: register 26 times 4 / 1000",
              .low = 0,
              .high = 1.016,
              .neutral = 0,
              .typical = 0.05,
              .logarithmic = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"viscous", "kt_error"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kLoadColumn});

class Derivative final : public EffectOf<kDerivative, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kControllerHook; }
  void controller(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [gain] = values_;
    s.d_gain += gain;
  }
};

}  // namespace

const EffectInfo kDerivative{{
    .id = "derivative",
    .title = "derivative gain (D)",
    .part = LoopPart::kController,
    .equation = "u += 8 K gain de/dt",
    .signature = "Damped steps, a load spike when the goal jumps, rough load in a smooth move.",
    .separated_by =
        "Swing with torque off against a powered one: damping by the controller disappears with the torque.",
    .source = "MX-28 manual, registers 26 to 28",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kVoltageP,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kEveryPeriod,  // swings at 1 ms where it damps at 0.1 ms
    .synthetic = {},
    .exports = {.webots = approximated("controlPID, D of a speed"),
                .mujoco = approximated("biasprm: brakes the joint; the goal's own speed is left out"),
                .urdf = lost(exports::kNoController)},
    .other_names = {},
    .make = makeEffect<Derivative>,
}};

}  // namespace darwinop::twin
