#include "gap/fit/servo_range.hpp"

#include <string_view>

namespace darwinop::gap {
namespace {

/// N m, at full duty and the given supply.
double stallTorque(const twin::ServoParameters& servo) {
  return servo.law == twin::Law::kSpeedP ? servo.torque_max_nm : servo.kt_nm_a * servo.supply_v / servo.resistance_ohm;
}

/// By the dimension of the parameter.
double inProportion(double stall, std::string_view unit) {
  if (unit == "N m" || unit == "N m s/rad") return stall;
  if (unit == "1/(N m)") return 1 / stall;
  return 1;
}

}  // namespace

std::vector<Unknown> unknownsOf(const twin::EffectInfo& info, const twin::ServoParameters& servo, bool refined,
                                const Place& place) {
  std::vector<Unknown> unknowns = unknownsOf(info, refined, place);
  if (info.part != twin::LoopPart::kFriction) return unknowns;
  const double stall = stallTorque(servo) / stallTorque({});
  for (Unknown& unknown : unknowns) {
    const auto& parameter = std::get<EffectParameter>(unknown.what);
    const double factor = inProportion(stall, info.parameters[parameter.index].unit);
    unknown.low *= factor, unknown.high *= factor, unknown.expected *= factor;
  }
  return unknowns;
}

}  // namespace darwinop::gap
