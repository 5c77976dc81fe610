// A limit of the speed at which the set point moves to the goal, as the register Moving Speed sets it. The law speed_p
// has no set point of its own: there it limits the motor.
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

const EffectInfo kSpeedLimit{
    .id = "speed_limit",
    .title = "speed limit",
    .place = Place::kCommand,
    .equation = "|d set_point/dt| <= speed; law speed_p: |w| <= speed",
    .signature = "Straight ramps of one slope after large steps; slower moves unchanged.",
    .separated_by =
        "Long step at two supply voltages: a limit keeps its slope, no-load speed does not. The duration grows in "
        "proportion to the step (accel_limit: with its square root).",
    .source = "MX-28 manual, register 32; range assumed, upper end widened until nothing is limited",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<SpeedLimit>,
};

}  // namespace darwinop::twin
