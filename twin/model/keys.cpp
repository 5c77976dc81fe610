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
Slot ofServo(Model& model, std::size_t /*link*/) {
  return &(model.servo.*Member);
}
template <auto Member>
Slot ofBody(Model& model, std::size_t /*link*/) {
  return &(model.body.*Member);
}
template <auto Member>
Slot ofImu(Model& model, std::size_t /*link*/) {
  return &(model.imu.*Member);
}
template <auto Member>
Slot ofLink(Model& model, std::size_t link) {
  return &(model.links[link].*Member);
}
Slot nameOf(Model& model, std::size_t /*link*/) {
  return &model.name;
}

using S = ServoParameters;
using B = BodySettings;
using I = ImuSettings;
using L = LinkSettings;
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
    {"servo", "armature", ofServo<&S::armature_kgm2>, {"kg m2", 0, 1}, {}, "inertia of rotor and gears at the horn"},
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
    {"body", "sole_size", ofBody<&B::sole_size>, {"", 0.1, 3}, {}, "factor on length and width of both soles"},
    {"body",
     "floor_tilt_x",
     ofBody<&B::floor_tilt_x_rad>,
     {"rad", -0.5, 0.5},
     {},
     "floor turned about the world's x, forward"},
    {"body", "floor_tilt_y", ofBody<&B::floor_tilt_y_rad>, {"rad", -0.5, 0.5}, {}, "then about y, left"},
    {"body",
     "battery_resistance",
     ofBody<&B::battery_resistance_ohm>,
     {"ohm", 0, 2},
     {},
     "of battery and cables that all servos share; law voltage_p"},
    {"body", "step", ofBody<&B::step_s>, {"s", 5e-5, 0.01}, {}, "of the physics"},

    {"imu", "gyro_range", ofImu<&I::gyro_range_rad_s>, {"rad/s", 0.05, 100}, {}, "saturates there"},
    {"imu", "accel_range", ofImu<&I::accel_range_m_s2>, {"m/s2", 1, 1000}, {}, "saturates there"},
    {"imu", "gyro_bias", ofImu<&I::gyro_bias_rad_s>, {"rad/s", -1, 1}, {}, "x, y, z"},
    {"imu", "accel_bias", ofImu<&I::accel_bias_m_s2>, {"m/s2", -10, 10}, {}, "x, y, z"},
    {"imu", "gyro_scale", ofImu<&I::gyro_scale>, {"", -3, 3}, {}, "x, y, z; -1 mirrors an axis"},
    {"imu", "accel_scale", ofImu<&I::accel_scale>, {"", -3, 3}, {}, "x, y, z; -1 mirrors an axis"},
    {"imu", "mounting", ofImu<&I::mounting_rad>, {"rad", -4, 4}, {}, "rotation vector of the board: left, up, forward"},
    {"imu", "gyro_axes", ofImu<&I::gyro_axes>, {"", -3, 3}, {}, "true axis read as x, y, z: 1 to 3; minus mirrors it"},
    {"imu",
     "accel_axes",
     ofImu<&I::accel_axes>,
     {"", -3, 3},
     {},
     "true axis read as x, y, z: 1 to 3; minus mirrors it"},
    {"imu", "gyro_lowpass", ofImu<&I::gyro_lowpass_s>, {"s", 0, 1}, {}, "time constant of its filter, first order"},
    {"imu", "delay", ofImu<&I::delay_s>, {"s", 0, 0.3}, {}, "of both sensors"},
    {"imu", "gyro_noise", ofImu<&I::gyro_noise_rad_s>, {"rad/s", 0, 1}, {}, "standard deviation per 1 ms sample"},
    {"imu", "accel_noise", ofImu<&I::accel_noise_m_s2>, {"m/s2", 0, 10}, {}, "standard deviation per 1 ms sample"},
};

constexpr KeyRow kLinkRows[] = {
    {kLinkSection, "mass", ofLink<&L::mass_kg>, {"kg", -5, 5}, {}, "added to that of the body file; less, if negative"},
    {kLinkSection,
     "mass_from_com",
     ofLink<&L::mass_from_com_m>,
     {"m", -0.5, 0.5},
     {},
     "its place in the link's frame, from the link's centre of mass"},
    {kLinkSection, "com_shift", ofLink<&L::com_shift_m>, {"m", -0.5, 0.5}, {}, "of the link's centre of mass"},
};

/// "link ArmLowerR"
const std::array<std::string, kLinks>& linkSectionNames() {
  static const std::array<std::string, kLinks> kNames = [] {
    std::array<std::string, kLinks> names;
    for (std::size_t i = 0; i < kLinks; ++i) names[i] = std::string{kLinkSection} + " " + std::string{linkName(i)};
    return names;
  }();
  return kNames;
}

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
static_assert(std::size(kLinkRows) == members<LinkSettings>(),
              "a new setting of a link needs a row in the table above");

}  // namespace

std::span<const KeyRow> keyTable() {
  static const std::vector<KeyRow> kAll = [] {
    std::vector<KeyRow> rows(std::begin(kTable), std::end(kTable));
    for (std::size_t link = 0; link < kLinks; ++link)
      for (const KeyRow& row : kLinkRows) {
        rows.push_back(row);
        rows.back().section = linkSectionNames()[link];
        rows.back().in.link = link;
      }
    return rows;
  }();
  return kAll;
}

std::span<const std::string_view> plainSections() {
  return kSections;
}

std::string_view linkSection(std::size_t link) {
  return linkSectionNames()[link];
}

const KeyRow* findKey(std::string_view section, std::string_view key) {
  const auto all = keyTable();
  const auto found =
      std::ranges::find_if(all, [&](const KeyRow& row) { return row.section == section && row.key == key; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string_view> keysOf(std::string_view section) {
  std::vector<std::string_view> keys;
  for (const KeyRow& row : keyTable())
    if (row.section == section) keys.push_back(row.key);
  return keys;
}

NumberRule ruleOf(const Parameter& parameter) {
  // Ranges of torques and inertias are those of an MX-28; other servos have up to ten times as much, or as little.
  constexpr std::string_view kOfTheServosSize[] = {"N m", "N m s/rad", "1/(N m)", "kg m2"};
  const double factor = std::ranges::find(kOfTheServosSize, parameter.unit) != std::end(kOfTheServosSize) ? 10 : 1;
  return {parameter.unit, parameter.low * (parameter.low < 0 ? factor : 1 / factor), factor * parameter.high};
}

}  // namespace darwinop::twin
