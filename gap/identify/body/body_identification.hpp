// Which effect of a whole robot explains what the table shows. Today: effects of a resting inertial sensor.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

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
  // Rms of mean - expected over the held-out logs with a clamped trunk, and the noise of one reading; NaN: there are
  // none.
  double held_out_before = 0, held_out_after = 0, held_out_floor = 0;
};

/// `imu`: of the case's model. No sensor without a log with a clamped trunk.
std::vector<SensorSelection> identifySensors(const BodyCase& given, const RestingImu& imu, const BodyTable& table);

struct BodyIdentification {
  Verdict verdict = Verdict::kCannotTell;  // never kNone: not all blocks are tested
  std::vector<SensorSelection> sensors;
  BodyTable table;
  double runtime_s = 0;
};

BodyIdentification identify(const BodyCase& given);

/// For a terminal; for programs: verdict, effects, ambiguity, where and scores.
std::string asText(const BodyIdentification& found);
nlohmann::ordered_json asJson(const BodyCase& given, const BodyIdentification& found);

}  // namespace darwinop::gap
