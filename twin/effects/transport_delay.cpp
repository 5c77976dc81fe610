// Effect: transport delay of goals, and of the position that the controller reads.
#include <algorithm>
#include <cmath>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kTransportDelay;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "delay",
              .unit = "s",
              .meaning = "time until a goal acts",
              .low = 0,
              .high = 0.08,
              .neutral = 0,
              .typical = 0.008,
              .logarithmic = true,
              .role = ParameterRole::kGoalDelay},
    Parameter{.key = "reading",
              .unit = "s",
              .meaning = "age of the position that the controller reads",
              .low = 0,
              .high = 0.02,
              .neutral = 0,
              .typical = 0,
              .secondary = true},
};
constexpr auto kConfusedWith =
    std::to_array<std::string_view>({"viscous", "accel_limit", "lost_packets", "inertia", "joint_flex"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kHostRate});
constexpr auto kOtherNames = std::to_array<OtherName>({{"d", "delay"}});

// Delay line with linear interpolation between samples, so that a fit sees a smooth function of the delay.
class DelayLine {
 public:
  void fill(double value) noexcept { ring_.fill(value); }
  double pass(double value, double periods) noexcept {
    ring_[++head_ % kSize] = value;
    periods = std::min(periods, kSize - 2.0);
    const double nearest = std::nearbyint(periods);
    if (std::abs(periods - nearest) < 1e-6) return ago(nearest);  // 0.007 / 0.001 is not an integer in floating point
    const double whole = std::floor(periods);
    return ago(whole) + (periods - whole) * (ago(whole + 1) - ago(whole));
  }

 private:
  static constexpr std::uint32_t kSize = 1024;  // samples; 80 ms at a period of 0.1 ms are 800
  [[nodiscard]] double ago(double periods) const noexcept {
    return ring_[(head_ - static_cast<std::uint32_t>(periods)) % kSize];
  }

  std::array<double, kSize> ring_{};
  std::uint32_t head_ = 0;
};

class TransportDelay final : public EffectOf<kTransportDelay, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kCommandHook | kSensorHook; }
  void reset(const Signals& now) noexcept override {
    goals_.fill(now.goal_rad);
    readings_.fill(now.measured_rad);
  }
  void command(Signals& s, double dt_s) noexcept override { s.goal_rad = goals_.pass(s.goal_rad, values_[0] / dt_s); }
  void sensor(Signals& s, double dt_s) noexcept override {
    s.measured_rad = readings_.pass(s.measured_rad, values_[1] / dt_s);
  }

 private:
  DelayLine goals_, readings_;
};

}  // namespace

const EffectInfo kTransportDelay{{
    .id = "transport_delay",
    .title = "command delay",
    .part = LoopPart::kCommand,
    .equation = "goal(t) = goal sent at t - delay; measured(t) = measured at t - reading",
    .signature = "Error proportional to goal speed at every P gain; dead time after a step. Below one host period the "
                 "controller block does not show it.",
    .separated_by =
        "Chirp: the phase lag grows linearly with frequency. Step: the reaction starts late, then with full "
        "acceleration.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kAtHost,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {.pair_rank = 10},
    .exports = inAllFormats(lost("commands act in the same step; delay them in the controller")),
    .other_names = kOtherNames,
    .make = makeEffect<TransportDelay>,
}};

}  // namespace darwinop::twin
