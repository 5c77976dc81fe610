// Play between the gears and the horn: the encoder sits on the horn, the motor first has to cross the gap.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kBacklash;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "play",
              .unit = "rad",
              .meaning = "total gap, from one flank to the other",
              .low = 0,
              .high = 0.06,
              .neutral = 0,
              .typical = 0.0058,
              .logarithmic = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"deadband", "coulomb", "joint_flex", "encoder_offset"});

class Backlash final : public EffectOf<kBacklash, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kMechanicsHook; }
  void mechanics(Signals& s) noexcept override {
    const auto& [play] = values_;
    s.backlash_rad = play;
  }
};

}  // namespace

const EffectInfo kBacklash{
    .id = "backlash",
    .title = "gear backlash",
    .place = Place::kTransmission,
    .equation = "no torque between gears and horn while |q_gears - q_horn| < play / 2",
    .signature = "Free motion and hunting where the load changes sign; an irregular first swing after a release.",
    .separated_by =
        "Hold where gravity pulls one way, not at all, and the other way; compare a small sine around hanging with one "
        "at 60 degrees.",
    .source = "MX-28: 20 arcmin; simulator model of the OP2: 0.01 rad; range assumed",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<Backlash>,
};

}  // namespace darwinop::twin
