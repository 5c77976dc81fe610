// Effect: speed limit of the set point (register Moving Speed). Law speed_p has no profile: there it limits the motor.
#include <algorithm>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kSpeedLimit;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "speed",
              .unit = "rad/s",
              .meaning = "greatest set point speed",
              .low = 0.5,
              .high = 200,
              .neutral = 200,
              .typical = 3,
              .logarithmic = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"accel_limit", "supply_sag", "kt_error"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kFastMotion});
constexpr auto kOtherNames = std::to_array<OtherName>({{"v_lim", "speed"}});

class SpeedLimit final : public EffectOf<kSpeedLimit, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kCommandHook; }
  void command(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [speed] = values_;
    if (speed < kParameters[0].neutral) s.profile_speed_rad_s = std::min(s.profile_speed_rad_s, speed);
  }
};

}  // namespace

const EffectInfo kSpeedLimit{{
    .id = "speed_limit",
    .title = "speed limit",
    .part = LoopPart::kCommand,
    .equation = "|d set_point/dt| <= speed; law speed_p: |w| <= speed",
    .signature = "Straight ramps of one slope after large steps; slower moves unchanged.",
    .separated_by =
        "Long step at two supply voltages: a limit keeps its slope. Duration grows with the step (accel_limit: with "
        "its square root).",
    .source = "MX-28 manual, register 32; range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.pair_rank = 2},
    .exports = {.webots = approximated("maxVelocity: it limits the motor, not the goal's way"),
                .mujoco = lost("a position actuator has no limit of speed; move the goal in the controller"),
                .urdf = approximated("limit velocity: it limits the joint, not the goal's way")},
    .other_names = kOtherNames,
    .make = makeEffect<SpeedLimit>,
}};

}  // namespace darwinop::twin
