// Effect: encoder with a coarser resolution than ServoParameters::ticks_per_rev.
#include <cmath>

#include "core/units.hpp"
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kEncoderQuantisation;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "ticks",
              .unit = "",
              .meaning = "steps per turn",
              .low = 256,
              .high = 65536,
              .neutral = 65536,
              .typical = 1024,
              .logarithmic = true,
              .role = ParameterRole::kEncoderTicks},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"deadband"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kHostRate});

class EncoderQuantisation final : public EffectOf<kEncoderQuantisation, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kSensorHook; }
  void sensor(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [ticks] = values_;
    if (ticks >= kParameters[0].neutral) return;
    const double tick = 2 * kPi / ticks;
    s.measured_rad = std::nearbyint(s.measured_rad / tick) * tick;
  }
};

}  // namespace

const EffectInfo kEncoderQuantisation{{
    .id = "encoder_quantisation",
    .title = "coarse encoder",
    .part = LoopPart::kSensor,
    .equation = "measured = round(q ticks / 2 pi) 2 pi / ticks",
    .signature = "Positions on a coarse grid; at rest the load moves in steps. Only the noise floor rises.",
    .separated_by = "Sort the positions of a slow move: the smallest difference is the step.",
    .source = "MX-28 manual: 4096 steps per turn",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kFirmwareOnly,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {},
    .exports = {.webots = approximated("resolution of the PositionSensor; the motor's own loop sees the exact angle"),
                .mujoco = approximated(
                    "noise of the jointpos sensor, as large as the rounding; the actuator sees the exact angle"),
                .urdf = lost("the format has no sensor of a joint")},
    .other_names = {},
    .make = makeEffect<EncoderQuantisation>,
}};

}  // namespace darwinop::twin
