// The bench of a log: numbers of the case, unless the log has its own.
#include "gap/case/case.hpp"

namespace darwinop::gap {

twin::Pendulum armOf(const Case& c, const Trajectory& log) {
  twin::Pendulum arm = c.pendulum;
  arm.payload_kg = log.payload_kg;
  arm.length_m = log.length_m.value_or(arm.length_m);
  arm.arm_mass_kg = log.arm_mass_kg.value_or(arm.arm_mass_kg);
  return arm;
}

double supplyOf(const Case& c, const Trajectory& log) {
  return log.supply_v.value_or(c.model.servo.supply_v);
}

}  // namespace darwinop::gap
