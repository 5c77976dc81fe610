// The table.
#include "gap/case/baseline_keys.hpp"

#include <array>

#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"

namespace darwinop::gap {
namespace {

using S = twin::ServoParameters;

constexpr auto kServoKeys = std::to_array<ServoKey>({
    {"kt_Nm_A", "kt", &S::kt_nm_a, true, false},
    {"R_ohm", "resistance", &S::resistance_ohm, true, false},
    {"supply_V", "supply", &S::supply_v, true, false},
    {"duty_per_kp_per_rad", "duty_per_kp", &S::duty_per_kp_per_rad, true, false},
    {"duty_max", "duty_max", &S::duty_max, true, false},
    {"speed_gain_per_kp_1_s", "speed_gain_per_kp", &S::speed_gain_per_kp_1_s, false, true},
    {"v_max_rad_s", "speed_max", &S::speed_max_rad_s, false, true},
    {"torque_max_Nm", "torque_max", &S::torque_max_nm, false, true},
    {"armature_kgm2", "armature", &S::armature_kgm2, true, true},
    {"firmware_dt_s", "firmware_period", &S::firmware_period_s, true, true},
    {"ticks_per_rev", "ticks_per_rev", &S::ticks_per_rev, true, true},
});

// Ranges: what a servo of this size can swing.
constexpr auto kArmKeys = std::to_array<ArmKey>({
    {"arm_mass_kg", "arm_mass", &twin::Pendulum::arm_mass_kg, &Trajectory::arm_mass_kg, {"kg", 0, 20}},
    {"length_m", "length", &twin::Pendulum::length_m, &Trajectory::length_m, {"m", 0.005, 2}},
    {"payload_kg", "payload", nullptr, nullptr, {"kg", 0, 20}},
});

}  // namespace

std::span<const ServoKey> servoKeys() {
  return kServoKeys;
}

twin::NumberRule ruleOf(const ServoKey& key) {
  return twin::findKey("servo", key.key)->number;
}

std::vector<FrictionKey> frictionKeys() {
  std::vector<FrictionKey> keys;
  for (const twin::EffectInfo* const effect : twin::catalogue())
    for (const twin::BaselineAlias& alias : effect->aliases)
      if (alias.relation == twin::BaselineAlias::Relation::kOwnValue)
        keys.push_back({alias.case_key, effect, alias.number});
  return keys;
}

std::span<const ArmKey> armKeys() {
  return kArmKeys;
}

}  // namespace darwinop::gap
