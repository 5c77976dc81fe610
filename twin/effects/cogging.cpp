// Torque that depends on the angle alone: cogging of the motor, or a wheel that runs out of true.
#include <cmath>

#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kCogging;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "amplitude",
              .unit = "N m",
              .meaning = "of the ripple, at the horn",
              .low = 0,
              .high = 0.15,
              .neutral = 0,
              .typical = 0.03,
              .logarithmic = true},
    Parameter{.key = "count",
              .unit = "",
              .meaning = "ripples per turn of the horn; 1 and 2: an eccentric wheel",
              .low = 1,
              .high = 60,
              .neutral = 24,
              .typical = 24},
    Parameter{.key = "phase",
              .unit = "rad",
              .meaning = "of the ripple at angle 0",
              .low = -3.15,
              .high = 3.15,
              .neutral = 0,
              .typical = 0},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"stribeck", "joint_flex"});

class Cogging final : public EffectOf<kCogging, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [amplitude, count, phase] = values_;
    s.extra_torque_nm += amplitude * std::sin(count * s.position_rad + phase);
  }
};

}  // namespace

const EffectInfo kCogging{
    .id = "cogging",
    .title = "torque ripple",
    .place = Place::kMotor,
    .equation = "tm = tm + amplitude sin(count q + phase)",
    .signature = "Position ripple locked to the angle, the same at all speeds.",
    .separated_by =
        "Slow triangle at two speeds: the ripple keeps its place over the angle, and its frequency in time doubles.",
    .source = "Range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<Cogging>,
};

}  // namespace darwinop::twin
