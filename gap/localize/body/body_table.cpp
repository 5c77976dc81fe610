#include "gap/localize/body/body_table.hpp"

#include <algorithm>

#include "core/text/nearest.hpp"
#include "gap/localize/absorb.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Axes of the inertial sensor that no clamped log has a reading of.
std::vector<std::string> silentAxes(const std::vector<BodyRow>& rows) {
  std::vector<std::string> out;
  for (const ImuSensor sensor : kImuSensors)
    for (const char axis : {'x', 'y', 'z'}) {
      const std::string signal = std::string{name(sensor)} + "." + axis;
      const bool is_read = std::ranges::any_of(
          rows, [&](const BodyRow& row) { return row.block == Block::kSensor && row.signal == signal; });
      if (!is_read) out.push_back(signal);
    }
  return out;
}

std::vector<std::string> notTested(const std::vector<BodyRow>& rows, const BodyCase& given) {
  std::vector<std::string> out;
  if (!given.isComplete()) out.push_back(absentText(given));
  if (std::ranges::none_of(rows, [](const BodyRow& row) { return row.place.kind == Place::Kind::kContact; }))
    out.emplace_back(kNoFloorSignals);
  const auto has = [&](Block block) { return std::ranges::find(rows, block, &BodyRow::block) != rows.end(); };
  if (!has(Block::kController)) out.emplace_back("controller: no load and position of a driven joint");
  if (!has(Block::kPlant))
    out.emplace_back("mechanics of the joints: no log with \"setup\": \"stand_clamped\", or law speed_p");
  if (!has(Block::kSupply)) out.emplace_back("supply: too few voltages of servos");
  if (!has(Block::kSensor))
    out.emplace_back("inertial sensor: no reading in a log with \"setup\": \"stand_clamped\"");
  else if (const std::vector<std::string> silent = silentAxes(rows); !silent.empty())
    out.push_back(text::listed(std::vector<std::string_view>{silent.begin(), silent.end()}) +
                  ": no reading in a log with \"setup\": \"stand_clamped\"");
  return out;
}

}  // namespace

std::size_t BodyTable::open() const {
  return static_cast<std::size_t>(std::ranges::count_if(rows, &BodyRow::open));
}

BodyTable tableOf(std::vector<BodyRow> rows, const BodyCase& given) {
  std::erase_if(rows, [](const BodyRow& row) { return !row.is_measured; });
  BodyTable table{.rows = std::move(rows), .not_tested = {}};
  table.not_tested = notTested(table.rows, given);
  table.open_from =
      sigmasOfChance(thresholds::kFalseDiscoveries / std::max<double>(1, static_cast<double>(table.rows.size())));
  for (BodyRow& row : table.rows) row.open = row.significance > table.open_from;
  std::ranges::stable_sort(table.rows, [](const BodyRow& a, const BodyRow& b) {
    return a.significance != b.significance ? a.significance > b.significance : a.floors > b.floors;
  });
  return table;
}

namespace {

std::vector<BodyRow> ownRows(const BodyCase& given, const RestingImu& imu, const BodyHypothesis& robot) {
  std::vector<BodyRow> rows = jointRows(given, robot.has_board_supply);
  for (BodyRow& row : imuRows(given, imu)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace

BodyTable localize(const BodyCase& given, const RestingImu& imu) {
  return tableOf(ownRows(given, imu, declaredRobot(given)), given);
}

BodyTable localize(const BodyCase& given, const RestingImu& imu, const ClampedRobot& robot) {
  std::vector<BodyRow> rows = ownRows(given, imu, robot.baseline());
  for (BodyRow& row : mechanicsRows(robot, robot.baseline())) rows.push_back(std::move(row));
  return tableOf(std::move(rows), given);
}

}  // namespace darwinop::gap
