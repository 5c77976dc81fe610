#include "gap/case/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.hpp"
#include "gap/case/plausible.hpp"

namespace darwinop::gap {
namespace {

constexpr double kRoom = 2;
constexpr double kGreatestSagOhm = 4;  // of a cable and a supply, as of effect supply_sag
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double stallTorque(const twin::ServoParameters& servo, double supply_v) {
  if (servo.law == twin::Law::kSpeedP) return servo.torque_max_nm;
  return servo.kt_nm_a * servo.duty_max * supply_v / servo.resistance_ohm;
}

}  // namespace

PhysicalLimits limitsOf(const Case& c, const Trajectory& log, double volt_v) {
  const twin::ServoParameters& servo = c.model.servo;
  const twin::Pendulum arm = armOf(c, log);
  const double weight_nm = (arm.payload_kg + arm.arm_mass_kg / 2) * arm.length_m * arm.gravity_m_s2;
  const double inertia = (arm.payload_kg + arm.arm_mass_kg / 3) * arm.length_m * arm.length_m + servo.armature_kgm2;
  const double fall_rad_s = 2 * std::sqrt(arm.gravity_m_s2 / arm.length_m);
  PhysicalLimits limits{
      .speed_rad_s = kRoom * std::max(noLoadSpeed(c, log), fall_rad_s),
      .accel_rad_s2 = inertia > 0 ? kRoom * (stallTorque(servo, supplyOf(c, log)) + weight_nm) / inertia : kInfinity,
      .low_v = -kInfinity,
      .high_v = kInfinity,
      .heating_k_s = kInfinity,
      .encoder_step_rad = 2 * kPi / servo.ticks_per_rev};
  if (servo.law == twin::Law::kSpeedP || std::isnan(volt_v)) return limits;
  const double through_sag = kGreatestSagOhm / (kGreatestSagOhm + servo.resistance_ohm);
  limits.low_v = volt_v * (1 - through_sag);
  limits.high_v = volt_v * (1 + through_sag);
  limits.heating_k_s = kRoom * volt_v * volt_v / servo.resistance_ohm / servo.heat_capacity_j_k;
  return limits;
}

}  // namespace darwinop::gap
