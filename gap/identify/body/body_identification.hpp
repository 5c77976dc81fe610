// Which effects of a whole robot explain what the table shows: of a resting inertial sensor, of joints and links while
// the trunk is clamped, of trunk, floor and moving sensor on the floor.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gap/identify/body/battery.hpp"
#include "gap/identify/body/floor_selection.hpp"
#include "gap/identify/body/held_out_gap.hpp"
#include "gap/identify/body/mechanics_selection.hpp"
#include "gap/identify/body/sensor_effect.hpp"
#include "gap/identify/identification.hpp"
#include "gap/localize/body/body_table.hpp"

namespace darwinop::gap {

/// The selected model of one sensor.
struct SensorSelection {
  ImuSensor sensor{};
  SensorFit found;                // without effects: the model as it is
  std::vector<SensorFit> rivals;  // that the data do not exclude, best first
  bool remains = false;           // what is left is beyond BodyTable::open_from
};

/// `imu`: of the case's model. No sensor without a log with a clamped trunk.
std::vector<SensorSelection> identifySensors(const BodyCase& given, const RestingImu& imu, const BodyTable& table);

/// What is looked at: the inertial sensor needs no simulation.
enum class BodyScope : std::uint8_t { kAll, kSensors };

struct BodyIdentification {
  Verdict verdict = Verdict::kCannotTell;  // kNone: agreement, and everything is tested
  std::vector<SensorSelection> sensors;
  std::optional<FoundBattery> battery;  // the simulations then have the measured supply
  MechanicsSelection mechanics;
  FloorSelection floor;
  BodyTable table;  // its rows of the floor are about what clamped logs have shown
  HeldOutGap held_out;
  double runtime_s = 0;
};

BodyIdentification identify(const BodyCase& given, BodyScope scope = BodyScope::kAll);

/// Sentence of BodyTable::not_tested.
inline constexpr const char* kLegNotExplained = "trunk, floor, contact: joints of a leg are not explained";
/// Of rivals: what to do.
inline constexpr const char* kSeparatedByPlan = "`darwinop gap plan` names the experiment that separates them";
/// Before the signals that nothing named explains.
inline constexpr const char* kNotExplained = "  not explained: ";

/// For a terminal; for programs: verdict, effects, ambiguity, where and scores.
std::string asText(const BodyIdentification& found);
nlohmann::ordered_json asJson(const BodyCase& given, const BodyIdentification& found);

}  // namespace darwinop::gap
