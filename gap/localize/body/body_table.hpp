// Where recordings of a robot and its model diverge, before any fit: a table of signal, place and block. Each block
// gets its measured input, and its output is compared with the measured one; no closed loop is simulated.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "gap/case/body/body_case.hpp"
#include "gap/localize/body/clamped_robot.hpp"
#include "gap/plant/block.hpp"
#include "gap/plant/body/resting_imu.hpp"
#include "gap/plant/place.hpp"

namespace darwinop::gap {

struct BodyRow {
  std::string signal;  // "AnkleR.load", "gyro.x"
  Place place;         // what is tested
  Block block = Block::kController;
  std::string unit;
  double size = 0;          // rms of measured - expected
  double floors = 0;        // that, over the noise of one reading
  double significance = 0;  // standard deviations of a normal distribution, after what the priors explain
  bool open = false;        // beyond BodyTable::open_from
  bool is_measured = true;  // false: of a limb with a joint that never answers

  // Where it is largest: half a second of a log.
  std::string file = {};
  double t0_s = 0, t1_s = 0;
};

/// Sentence of BodyTable::not_tested.
inline constexpr const char* kNoFloorSignals =
    "trunk, floor, contact, gyroscope in motion: no log with \"setup\": \"floor\" that is not of the runtime, or law "
    "speed_p";

struct BodyTable {
  std::vector<BodyRow> rows;  // most significant first
  // Significance from which a row is open: of all rows of a right model, the greatest is beyond it in 1 % of cases
  // (Bonferroni), however many rows there are.
  double open_from = 0;
  std::vector<std::string> not_tested;  // sentences

  [[nodiscard]] std::size_t open() const;
};

/// Those that are measured, most significant first, with the level that their number asks for.
BodyTable tableOf(std::vector<BodyRow> rows, const BodyCase& given);
/// Deterministic; under a second for ten logs. Only logs that are not held out.
BodyTable localize(const BodyCase& given, const RestingImu& imu);
/// With the mechanics of the joints.
BodyTable localize(const BodyCase& given, const RestingImu& imu, const ClampedRobot& robot);

/// For a terminal of 100 columns.
std::string asText(const BodyTable& table);
nlohmann::ordered_json asJson(const BodyTable& table);

// Parts of localize(). `has_board_supply`: as in BodyHypothesis.
std::vector<BodyRow> jointRows(const BodyCase& given, bool has_board_supply);
std::vector<BodyRow> imuRows(const BodyCase& given, const RestingImu& imu);
/// A row for each joint of the limb.
std::vector<BodyRow> limbRows(const ClampedRobot& robot, std::size_t limb, const BodyHypothesis& hypothesis);
/// The same, limb by limb; none where the robot cannot be tested.
std::vector<BodyRow> mechanicsRows(const ClampedRobot& robot, const BodyHypothesis& hypothesis);

}  // namespace darwinop::gap
