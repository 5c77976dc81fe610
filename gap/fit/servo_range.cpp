#include "gap/fit/servo_range.hpp"

#include <algorithm>
#include <string_view>

#include "twin/model/keys.hpp"

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
    const twin::Parameter& row = info.parameters[parameter.index];
    const double factor = inProportion(servo, info.part, row.unit);
    const twin::NumberRule allowed = twin::ruleOf(row);  // in a model file
    unknown.low = std::max(factor * unknown.low, allowed.low);
    unknown.high = std::min(factor * unknown.high, allowed.high);
    unknown.expected = std::clamp(factor * unknown.expected, unknown.low, unknown.high);
  }
  return unknowns;
}

}  // namespace darwinop::gap
