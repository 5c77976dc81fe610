// Effect: lost and late commands. Random draws use a counter and a seed, so a run is repeatable.
#include <cmath>

#include "core/random.hpp"
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kLostPackets;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "loss",
              .unit = "",
              .meaning = "fraction of packets lost",
              .low = 0,
              .high = 0.2,
              .neutral = 0,
              .typical = 0.05},
    Parameter{.key = "jitter",
              .unit = "s",
              .meaning = "standard deviation of the delay",
              .low = 0,
              .high = 0.005,
              .neutral = 0,
              .typical = 0,
              .secondary = true},
    Parameter{.key = "period",
              .unit = "s",
              .meaning = "longest period of goal writes",
              .low = 0.001,
              .high = 0.05,
              .neutral = 0.016,
              .typical = 0.016,
              .secondary = true},
    Parameter{.key = "seed",
              .unit = "",
              .meaning = "of the random sequence",
              .low = 0,
              .high = 1000000,
              .neutral = 1,
              .typical = 1,
              .secondary = true,
              .fixed = true,
              .error_scale = ErrorScale::kNone},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"transport_delay"});
constexpr auto kRevealedBy = std::to_array<LogFeature>({LogFeature::kHostRate});

class LostPackets final : public EffectOf<kLostPackets, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kCommandHook; }
  void reset(const Signals& now) noexcept override {
    sent_ = due_ = held_ = now.goal_rad;
    since_s_ = wait_s_ = 0;
    waiting_ = false;
    draws_ = 0;
  }
  void command(Signals& s, double dt_s) noexcept override {
    const auto& [loss, jitter, period, seed] = values_;
    since_s_ += dt_s;
    wait_s_ -= dt_s;
    // A packet is detected by a changed goal or by the write period.
    if (s.goal_rad != sent_ || since_s_ > period - 0.5 * dt_s) {
      sent_ = s.goal_rad;
      since_s_ = 0;
      if (uniform(seed) >= loss) {
        due_ = sent_;
        waiting_ = true;
        wait_s_ = jitter * std::abs(normal(seed));
      }
    }
    if (waiting_ && wait_s_ < 0.5 * dt_s) {
      held_ = due_;
      waiting_ = false;
    }
    s.goal_rad = held_;
  }

 private:
  double uniform(double seed) noexcept {
    return uniformFrom(splitMix(static_cast<std::uint64_t>(seed) * 0xd1342543de82ef95U + ++draws_ * kSplitMixStep));
  }
  // Approximately standard normal: a sum of 12 uniform draws has variance 1.
  double normal(double seed) noexcept {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform(seed);
    return sum;
  }

  double sent_ = 0, due_ = 0, held_ = 0;  // goal last written, in transit, in effect; rad
  double since_s_ = 0, wait_s_ = 0;       // since the last write; until the goal in transit arrives
  bool waiting_ = false;
  std::uint64_t draws_ = 0;
};

}  // namespace

const EffectInfo kLostPackets{{
    .id = "lost_packets",
    .title = "lost and late commands",
    .part = LoopPart::kCommand,
    .equation = "goal stays as it was for a share loss of the packets; the others act |N(0, jitter)| later",
    .signature = "Single rows, at random times, in which the servo moves to the old goal.",
    .separated_by = "Repeat a log: lost packets affect other rows, a delay all.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .laws = Laws::kBoth,
    .visibility = Visibility::kFirmwareOnly,
    .revealed_by = kRevealedBy,
    .prevalence = Prevalence::kRare,
    .aliases = {},
    .step_demand = StepDemand::kNone,
    .synthetic = {},
    .exports = inAllFormats(lost("every command arrives; drop them in the controller")),
    .other_names = {},
    .make = makeEffect<LostPackets>,
}};

}  // namespace darwinop::twin
