// Effect: limit of the bridge duty (register Torque Limit) or of the motor torque.
#include <algorithm>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kTorqueLimit;

namespace {

constexpr std::array kParameters{
    Parameter{
        .key = "duty", .unit = "", .meaning = "greatest duty", .low = 0.15, .high = 1, .neutral = 1, .typical = 0.6},
    Parameter{.key = "torque",
              .unit = "N m",
              .meaning = "greatest torque of the motor",
              .low = 0.2,
              .high = 10,
              .neutral = 10,
              .typical = 10,
              .logarithmic = true},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"supply_sag", "accel_limit", "resistance_error", "quadratic_load_friction"});
constexpr auto kRevealedBy =
    std::to_array<LogFeature>({LogFeature::kLoadColumn, LogFeature::kVoltageColumn, LogFeature::kSaturation});
constexpr auto kOtherNames = std::to_array<OtherName>({{"dmax", "duty"},
                                                       {"duty_max", "duty"},
                                                       {"u_max", "duty"},
                                                       {"T", "torque"},
                                                       {"T_lim", "torque"},
                                                       {"tau_max", "torque"}});

class TorqueLimit final : public EffectOf<kTorqueLimit, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kControllerHook | kMotorHook; }
  void controller(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [duty, torque] = values_;
    s.duty_limit = std::min(s.duty_limit, duty);
  }
  void motor(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [duty, torque] = values_;
    if (torque < kParameters[1].neutral) s.torque_limit_nm = std::min(s.torque_limit_nm, torque);
  }
};

}  // namespace

const EffectInfo kTorqueLimit{{
    .id = "torque_limit",
    .title = "torque limit",
    .part = LoopPart::kController,
    .equation = "|u| <= duty and |tm| <= torque",
    .signature = "Load flat at a value below 100 % (duty), or torque flat at any speed; lifts fail at high payload.",
    .separated_by =
        "Step with payload: a limit is flat in the load, a sagging supply is not. Lift growing payloads: a limit stops "
        "at one torque, quadratic friction keeps growing.",
    .source = "MX-28 manual, register 34; range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.pair_rank = 3},
    .exports = {.webots = approximated("maxTorque; a limit of the duty lowers maxVelocity too"),
                .mujoco = approximated(
                    "forcerange: exact for a limit of the duty; one of the torque acts before the back EMF"),
                .urdf = approximated("limit effort; a limit of the duty lowers velocity too")},
    .other_names = kOtherNames,
    .make = makeEffect<TorqueLimit>,
}};

}  // namespace darwinop::twin
