// Effect: acceleration limit of the set point; with law speed_p, of the motor.
#include <algorithm>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kAccelLimit;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "accel",
              .unit = "rad/s2",
              .meaning = "greatest set point acceleration",
              .low = 5,
              .high = 10000,
              .neutral = 10000,
              .typical = 55,
              .logarithmic = true},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"speed_limit", "torque_limit", "transport_delay", "inertia"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kFastMotion});
constexpr auto kOtherNames = std::to_array<OtherName>({{"a_lim", "accel"}});

class AccelLimit final : public EffectOf<kAccelLimit, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kCommandHook; }
  void command(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [accel] = values_;
    if (accel < kParameters[0].neutral) s.profile_accel_rad_s2 = std::min(s.profile_accel_rad_s2, accel);
  }
};

}  // namespace

const EffectInfo kAccelLimit{{
    .id = "accel_limit",
    .title = "acceleration limit",
    .part = LoopPart::kCommand,
    .equation = "|d2 set_point/dt2| <= accel; law speed_p: |dw/dt| <= accel",
    .signature = "Rounded start and stop of large steps; the error grows with the number of reversals.",
    .separated_by =
        "Steps of three sizes, load below its limit: the duration grows with the square root of the size (speed_limit: "
        "in proportion).",
    .source = "2013 thesis 5.3.1: 55 rad/s2",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.pair_rank = 1},
    .exports = {.webots =
                    approximated("acceleration: it limits the motor's speed, and braking begins when P asks for it"),
                .mujoco = lost("a position actuator has no limit of acceleration; move the goal in the controller"),
                .urdf = lost("the format has no limit of acceleration")},
    .other_names = kOtherNames,
    .make = makeEffect<AccelLimit>,
}};

}  // namespace darwinop::twin
