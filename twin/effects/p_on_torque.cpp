// The law of the real servo in a model that has the other one: P sets the duty of the bridge, so torque, not speed.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

extern const EffectInfo kPOnTorque;

namespace {

constexpr std::array kParameters{
    Parameter{.key = "on",
              .unit = "",
              .meaning = "1: P sets the duty; 0: the law of the model file stays",
              .low = 0,
              .high = 1,
              .neutral = 0,
              .typical = 1,
              .secondary = true},
};
constexpr auto kConfusedWith = std::to_array<std::string_view>({"coulomb", "integral", "com_mass"});

class POnTorque final : public EffectOf<kPOnTorque, kParameters.size()> {
 public:
  using EffectOf::EffectOf;
  [[nodiscard]] std::uint8_t hooks() const noexcept override { return kCommandHook; }
  // First of all: the profile depends on the law already.
  void command(Signals& s, double /*dt_s*/) noexcept override {
    const auto& [on] = values_;
    if (on >= 0.5) s.law = Law::kVoltageP;
  }
};

}  // namespace

const EffectInfo kPOnTorque{
    .id = "p_on_torque",
    .title = "P acts on torque",
    .place = Place::kController,
    .equation = "u = K P e and tm = kt (u V - ke w) / R, in place of a speed in proportion to P e",
    .signature = "A loaded joint stops short by an amount proportional to load over P; at small P it never arrives.",
    .separated_by =
        "Step with payload at three P gains: final error times P is constant, and stays when held for 5 s (with "
        "integral it decays).",
    .source = "2013 thesis 5.3.3; MX-28 manual, register 28",
    .confused_with = kConfusedWith,
    .parameters = kParameters,
    .make = makeEffect<POnTorque>,
};

}  // namespace darwinop::twin
