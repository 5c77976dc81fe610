// Table of the keys of a model file. A struct member without a row fails a static_assert.
#include "twin/model/keys.hpp"

#include <algorithm>

namespace darwinop::twin {
namespace {

constexpr std::array<std::string_view, 4> kSections{"model", "servo", "body", "imu"};
constexpr std::array<std::string_view, 2> kLaws{"voltage_p", "speed_p"};
constexpr std::array<std::string_view, 3> kTrunkComs{"manufacturer", "webots-2013", "halfway"};
constexpr std::array<std::string_view, 2> kTrunkInertias{"box", "published"};
constexpr std::array<std::string_view, 2> kNoYes{"no", "yes"};

template <auto Member>
Slot ofServo(Model& model) {
  return &(model.servo.*Member);
}
template <auto Member>
Slot ofBody(Model& model) {
  return &(model.body.*Member);
}
template <auto Member>
Slot ofImu(Model& model) {
  return &(model.imu.*Member);
}
Slot nameOf(Model& model) {
  return &model.name;
}

using S = ServoParameters;
using B = BodySettings;
using I = ImuSettings;
constexpr bool kOrNone = true;

constexpr KeyRow kTable[] = {
    {"model", "name", nameOf, {}, {}, "in logs and plots"},

    {"servo", "law", ofServo<&S::law>, {}, kLaws, "the P gain sets voltage or speed"},
    {"servo", "firmware_period", ofServo<&S::firmware_period_s>, {"s", 1e-4, 0.02}, {}, "of the position loop"},
    {"servo", "ticks_per_rev", ofServo<&S::ticks_per_rev>, {"", 256, 1048576}, {}, "steps of the encoder"},
    {"servo", "kt", ofServo<&S::kt_nm_a>, {"N m/A", 0.01, 10}, {}, "torque at the horn per current"},
    {"servo", "resistance", ofServo<&S::resistance_ohm>, {"ohm", 0.1, 100}, {}, "of the winding"},
    {"servo", "back_emf", ofServo<&S::back_emf_vs_rad>, {"V s/rad", 0.01, 10}, {}, "voltage per speed of the horn"},
    {"servo", "supply", ofServo<&S::supply_v>, {"V", 3, 30}, {}, "of the single-joint bench"},
    {"servo",
     "duty_per_kp",
     ofServo<&S::duty_per_kp_per_rad>,
     {"1/rad", 1e-4, 10},
     {},
     "duty per P register unit and rad of error"},
    {"servo", "duty_max", ofServo<&S::duty_max>, {"", 0.01, 1}, {}, "greatest duty"},
    {"servo", "armature", ofServo<&S::armature_kgm2>, {"kg m2", 0, 0.1}, {}, "inertia of rotor and gears at the horn"},
    {"servo",
     "speed_gain_per_kp",
     ofServo<&S::speed_gain_per_kp_1_s>,
     {"1/s", 1e-3, 10},
     {},
     "law speed_p: speed per P register unit and rad of error"},
    {"servo", "speed_max", ofServo<&S::speed_max_rad_s>, {"rad/s", 0.1, 100}, {}, "law speed_p: greatest speed"},
    {"servo", "torque_max", ofServo<&S::torque_max_nm>, {"N m", 0.01, 20}, {}, "law speed_p: greatest torque"},
    {"servo",
     "accel_max",
     ofServo<&S::accel_max_rad_s2>,
     {"rad/s2", 0.1, 1e5, kOrNone},
     {},
     "law speed_p: greatest acceleration"},
    {"servo", "ambient", ofServo<&S::ambient_c>, {"degC", -20, 60}, {}, "room temperature"},
    {"servo",
     "heat_resistance",
     ofServo<&S::heat_resistance_k_w>,
     {"K/W", 0.1, 100},
     {},
     "temperature rise per power lost"},
    {"servo", "heat_capacity", ofServo<&S::heat_capacity_j_k>, {"J/K", 1, 10000}, {}, "of winding and case"},
    {"servo",
     "overload_share",
     ofServo<&S::overload_share>,
     {"", 0.1, 1},
     {},
     "of the torque limit; overloaded when standing above it"},
    {"servo",
     "overload_time",
     ofServo<&S::overload_time_s>,
     {"s", 0.01, 3600, kOrNone},
     {},
     "until an overload switches torque off"},

    {"body", "xml", ofBody<&B::xml>, {}, {}, "MuJoCo file, beside the model file or shipped"},
    {"body", "trunk_com", ofBody<&B::trunk_com>, {}, kTrunkComs, "centre of mass of the trunk"},
    {"body", "trunk_inertia", ofBody<&B::trunk_inertia>, {}, kTrunkInertias, "inertia of the trunk"},
    {"body", "self_collision", ofBody<&B::self_collision>, {}, kNoYes, "links collide with each other"},
    {"body",
     "hold_until_driven",
     ofBody<&B::hold_until_driven>,
     {},
     kNoYes,
     "joints keep their angles until torque is first enabled"},
    {"body", "floor_friction", ofBody<&B::floor_friction>, {"", 0, 5}, {}, "Coulomb coefficient of floor and robot"},
    {"body", "contact_time", ofBody<&B::contact_time_s>, {"s", 1e-4, 0.5}, {}, "at least two steps"},
    {"body", "step", ofBody<&B::step_s>, {"s", 5e-5, 0.01}, {}, "of the physics"},

    {"imu", "gyro_range", ofImu<&I::gyro_range_rad_s>, {"rad/s", 0.05, 100}, {}, "saturates there"},
    {"imu", "accel_range", ofImu<&I::accel_range_m_s2>, {"m/s2", 1, 1000}, {}, "saturates there"},
    {"imu", "gyro_bias", ofImu<&I::gyro_bias_rad_s>, {"rad/s", -1, 1}, {}, "x, y, z"},
    {"imu", "accel_bias", ofImu<&I::accel_bias_m_s2>, {"m/s2", -10, 10}, {}, "x, y, z"},
    {"imu", "gyro_scale", ofImu<&I::gyro_scale>, {"", -2, 2}, {}, "x, y, z; -1 mirrors an axis"},
    {"imu", "accel_scale", ofImu<&I::accel_scale>, {"", -2, 2}, {}, "x, y, z; -1 mirrors an axis"},
    {"imu", "mounting", ofImu<&I::mounting_rad>, {"rad", -4, 4}, {}, "rotation vector of the board: left, up, forward"},
    {"imu",
     "accel_axes",
     ofImu<&I::accel_axes>,
     {"", -3, 3},
     {},
     "true axis read as x, y, z: 1 to 3; minus mirrors it"},
    {"imu", "gyro_noise", ofImu<&I::gyro_noise_rad_s>, {"rad/s", 0, 1}, {}, "standard deviation per 1 ms sample"},
    {"imu", "accel_noise", ofImu<&I::accel_noise_m_s2>, {"m/s2", 0, 10}, {}, "standard deviation per 1 ms sample"},
};

/// Counts the members of an aggregate: the largest number of initializers that it accepts.
struct Anything {
  template <class T>
  constexpr operator T() const;
};
template <class T, class... Given>
consteval std::size_t members() {
  if constexpr (requires { T{Given{}..., Anything{}}; })
    return members<T, Given..., Anything>();
  else
    return sizeof...(Given);
}
consteval std::size_t rows(std::string_view section) {
  return static_cast<std::size_t>(std::ranges::count(kTable, section, &KeyRow::section));
}
static_assert(rows("servo") == members<ServoParameters>(), "a new number of the servo needs a row in the table above");
static_assert(rows("body") == members<BodySettings>(), "a new setting of the body needs a row in the table above");
static_assert(rows("imu") == members<ImuSettings>(), "a new setting of the IMU needs a row in the table above");

}  // namespace

std::span<const KeyRow> keyTable() {
  return kTable;
}

std::span<const std::string_view> plainSections() {
  return kSections;
}

const KeyRow* findKey(std::string_view section, std::string_view key) {
  const auto* const found =
      std::ranges::find_if(kTable, [&](const KeyRow& row) { return row.section == section && row.key == key; });
  return found == std::end(kTable) ? nullptr : found;
}

std::vector<std::string_view> keysOf(std::string_view section) {
  std::vector<std::string_view> keys;
  for (const KeyRow& row : kTable)
    if (row.section == section) keys.push_back(row.key);
  return keys;
}

NumberRule ruleOf(const Parameter& parameter) {
  // Ranges of torques are those of an MX-28; other servos have up to ten times as much, or as little.
  constexpr double kOtherServos = 10;
  const bool of_torque = parameter.unit == "N m" || parameter.unit == "N m s/rad" || parameter.unit == "1/(N m)";
  return {parameter.unit, parameter.low, (of_torque ? kOtherServos : 1) * parameter.high};
}

}  // namespace darwinop::twin
