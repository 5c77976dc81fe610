// Effect: dead band of the controller, with an optional minimum duty outside it.
#include <cmath>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kDeadband;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "width",
              .unit = "rad",
              .meaning = "errors up to this give no duty",
              .low = 0,
              .high = 0.04,
              .neutral = 0,
              .typical = 0.01,
              .logarithmic = true},
    Parameter{.key = "punch",
              .unit = "",
              .meaning = "least duty outside the dead band",
              .low = 0,
              .high = 0.1,
              .neutral = 0,
              .typical = 0,
              .secondary = true,
              .laws = Laws::kVoltageP},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"coulomb", "backlash", "stribeck"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kLoadColumn, LogFeature::kGains});
constexpr auto kOtherNames = std::to_array<OtherName>({{"deadband", "width"}, {"d", "width"}, {"u0", "punch"}});

class Deadband final : public EffectOf<kDeadband, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kControllerHook; }
  void controller(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [width, punch] = values_;
    const double beyond = std::abs(s.error_rad) - width;
    const double error = s.error_rad;
    if (beyond <= 0) {
      s.error_rad = 0;
    } else if (width > 0 || punch > 0) {
      s.error_rad = std::copysign(beyond, error);
      s.duty_offset += std::copysign(punch, error);
    }
  }
};

}  // namespace

const EffectInfo kDeadband{{
    .id = "deadband",
    .title = "dead band",
    .part = LoopPart::kController,
    .equation = "u = 0 if |e| <= width; else K P (e - width sign e) + punch sign e",
    .signature = "Load exactly 0 while the error is not; the joint stops anywhere within the band.",
    .separated_by =
        "Plot load against error: the flat piece around 0 is the band. Friction and backlash leave it straight.",
    .source = "Compliance margin and punch of this family's older registers; range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.pair_rank = 9},
    .exports = {.webots = lost("controlPID has no dead band; keep the goal at the angle in the controller"),
                .mujoco = lost("an affine actuator has no dead band"),
                .urdf = lost(exports::kNoController)},
    .other_names = kOtherNames,
    .make = makeEffect<Deadband>,
}};

}  // namespace darwinop::twin
