// Effect: replaces law speed_p by law voltage_p, in which P sets the bridge duty.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kPOnTorque;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "on",
              .unit = "",
              .meaning = "1: P sets the duty; 0: the law of the model file stays",
              .low = 0,
              .high = 1,
              .neutral = 0,
              .typical = 1,
              .secondary = true,
              .fixed = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"coulomb", "integral", "com_mass"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kGains});

class POnTorque final : public EffectOf<kPOnTorque, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kCommandHook; }
  // In the command hook, because the profile already depends on the law.
  void command(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [on] = values_;
    if (on >= 0.5) s.law = Law::kVoltageP;
  }
};

}  // namespace

const EffectInfo kPOnTorque{{
    .id = "p_on_torque",
    .title = "P acts on torque",
    .part = LoopPart::kController,
    .equation = "u = K P e and tm = kt (u V - ke w) / R, in place of a speed in proportion to P e",
    .signature = "A loaded joint stops short in proportion to load over P.",
    .separated_by =
        "Step with payload at three P gains: final error times P is constant, also after 5 s (integral: it decays).",
    .source = "2013 thesis 5.3.3; MX-28 manual, register 28",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kReplacesSpeedP,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.growth = Synthetic::Growth::kSwitch},
    .exports = {.webots = lost(exports::kSpeedMotor),
                .mujoco = held("actuator: gainprm and biasprm"),
                .urdf = lost(exports::kNoController)},
    .other_names = {},
    .make = makeEffect<POnTorque>,
}};

}  // namespace darwinop::twin
