#include "gap/fit/servo_range.hpp"

#include <string_view>

namespace darwinop::gap {
namespace {

/// N m, at full duty and the given supply.
double stallTorque(const twin::ServoParameters& servo) {
  return servo.law == twin::Law::kSpeedP ? servo.torque_max_nm : servo.kt_nm_a * servo.supply_v / servo.resistance_ohm;
}

/// Factor on a parameter of this part and dimension.
double inProportion(const twin::ServoParameters& servo, twin::LoopPart part, std::string_view unit) {
  const twin::ServoParameters usual;
  // A model without an armature says nothing of its size.
  if (unit == "kg m2") return servo.armature_kgm2 > 0 ? servo.armature_kgm2 / usual.armature_kgm2 : 1;
  if (part != twin::LoopPart::kFriction) return 1;
  const double stall = stallTorque(servo) / stallTorque(usual);
  if (unit == "N m" || unit == "N m s/rad") return stall;
  return unit == "1/(N m)" ? 1 / stall : 1;
}

}  // namespace

std::vector<Unknown> unknownsOf(const twin::EffectInfo& info, const twin::ServoParameters& servo, bool refined,
                                const Place& place) {
  std::vector<Unknown> unknowns = unknownsOf(info, refined, place);
  for (Unknown& unknown : unknowns) {
    const auto& parameter = std::get<EffectParameter>(unknown.what);
    const double factor = inProportion(servo, info.part, info.parameters[parameter.index].unit);
    unknown.low *= factor, unknown.high *= factor, unknown.expected *= factor;
  }
  return unknowns;
}

}  // namespace darwinop::gap
