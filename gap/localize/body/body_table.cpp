#include "gap/localize/body/body_table.hpp"

#include <algorithm>

#include "gap/localize/absorb.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

std::vector<std::string> notTested(const std::vector<BodyRow>& rows) {
  std::vector<std::string> out{
      "mechanics of the joints, masses, floor and contact: they need a simulation of the whole robot",
      "delays of a goal below one row, and what an encoder shows wrongly: load and position agree then",
      "gyroscope in motion (scale, axes, range, filter), and the mounting that it shares: a clamped trunk does not "
      "turn"};
  const auto has = [&](Block block) { return std::ranges::find(rows, block, &BodyRow::block) != rows.end(); };
  if (!has(Block::kController)) out.emplace_back("controller: no load and position of a driven joint");
  if (!has(Block::kSupply)) out.emplace_back("supply: too few voltages of servos");
  if (!has(Block::kSensor)) out.emplace_back("inertial sensor: no log with \"setup\": \"stand_clamped\"");
  return out;
}

}  // namespace

std::size_t BodyTable::open() const {
  return static_cast<std::size_t>(std::ranges::count_if(rows, &BodyRow::open));
}

BodyTable localize(const BodyCase& given, const RestingImu& imu) {
  BodyTable table{.rows = jointRows(given), .not_tested = {}};
  for (BodyRow& row : imuRows(given, imu)) table.rows.push_back(std::move(row));
  table.not_tested = notTested(table.rows);
  table.open_from =
      sigmasOfChance(thresholds::kFalseDiscoveries / std::max<double>(1, static_cast<double>(table.rows.size())));
  for (BodyRow& row : table.rows) row.open = row.significance > table.open_from;
  std::ranges::stable_sort(table.rows, [](const BodyRow& a, const BodyRow& b) {
    return a.significance != b.significance ? a.significance > b.significance : a.floors > b.floors;
  });
  return table;
}

}  // namespace darwinop::gap
