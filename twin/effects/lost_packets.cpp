// Commands that never reach the servo, or reach it late. The draws come from a counter and a seed, so a run repeats.
#include <cmath>

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
              .meaning = "standard deviation of the lateness; no packet is early",
              .low = 0,
              .high = 0.005,
              .neutral = 0,
              .typical = 0,
              .secondary = true},
    Parameter{.key = "period",
              .unit = "s",
              .meaning = "the host writes the goal at least this often",
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
              .secondary = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"transport_delay"});

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
    // A packet shows as a new goal, or as the old one written again.
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
  // splitmix64 of a counter: the same on every machine, and no state but the counter.
  double uniform(double seed) noexcept {
    std::uint64_t x = static_cast<std::uint64_t>(seed) * 0xd1342543de82ef95ULL + ++draws_ * 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53;
  }
  // Near enough: the sum of twelve has variance one.
  double normal(double seed) noexcept {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform(seed);
    return sum;
  }

  double sent_ = 0, due_ = 0, held_ = 0;  // last written, on its way, in force; rad
  double since_s_ = 0, wait_s_ = 0;
  bool waiting_ = false;
  std::uint64_t draws_ = 0;
};

}  // namespace

const EffectInfo kLostPackets{
    .id = "lost_packets",
    .title = "lost and late commands",
    .place = Place::kCommand,
    .equation = "goal stays as it was for a share loss of the packets; the others act |N(0, jitter)| later",
    .signature = "Single rows in which the servo still moves to the old goal, at random times.",
    .separated_by = "Repeat a log: lost packets affect other rows, a delay affects all. Host time stamps show jitter.",
    .source = "SyncWrite is not acknowledged; range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<LostPackets>,
};

}  // namespace darwinop::twin
