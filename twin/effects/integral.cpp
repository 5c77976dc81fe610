// Effect: integral gain in the position law.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kIntegral;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "gain",
              .unit = "1/s",
              .meaning = "Ki of the manual: register 27 times 1000 / 2048",
              .low = 0,
              .high = 124,
              .neutral = 0,
              .typical = 4,
              .logarithmic = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"coulomb", "p_on_torque", "kp_scale"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kLoadColumn});

class Integral final : public EffectOf<kIntegral, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kControllerHook; }
  void controller(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [gain] = values_;
    s.i_gain += gain;
  }
};

}  // namespace

const EffectInfo kIntegral{{
    .id = "integral",
    .title = "integral gain (I)",
    .part = LoopPart::kController,
    .equation = "u += 8 K gain integral(e dt), held within the limit of the duty",
    .signature = "The remaining error under load creeps to 0; overshoot after long errors.",
    .separated_by =
        "Hold for 5 s under load: the error decays with an integral gain and stays with friction or a low P gain.",
    .source = "MX-28 manual, registers 26 to 28",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kVoltageP,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {},
    .exports = {.webots = approximated("controlPID, I of a speed"),
                .mujoco = lost("an affine actuator has no integral"),
                .urdf = lost(exports::kNoController)},
    .other_names = {},
    .make = makeEffect<Integral>,
}};

}  // namespace darwinop::twin
