#include "gap/case/body/lost_rows.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace darwinop::gap {
namespace {

constexpr double kMostCycles = 1e9;     // half a year: beyond, `cycle` is not a counter
constexpr double kForgotten = 0.3;      // s, four periods of the position loop: what another goal has changed is gone
constexpr double kLongestHole = 20;     // rows
constexpr double kLongestHole_s = 0.5;  // as in a log of one servo

/// Rows that are lost before `row`.
double lostBefore(const logs::Column& cycle, std::size_t row) {
  const double lost = cycle.values[row] - cycle.values[row - 1] - 1;
  return lost > 0 && lost < kMostCycles ? lost : 0;
}

}  // namespace

std::size_t lostRows(const logs::Log& recording) {
  const logs::Column* const cycle = recording.find("cycle");
  if (cycle == nullptr || recording.rows() == 0) return static_cast<std::size_t>(recording.lost_rows);
  const double span = cycle->values.back() - cycle->values.front() + 1;
  const auto rows = static_cast<double>(recording.rows());
  return span > rows && span < kMostCycles ? static_cast<std::size_t>(span - rows) : 0;
}

void forgetAfterLostRows(const logs::Log& recording, std::span<Trajectory> joints) {
  const logs::Column* const cycle = recording.find("cycle");
  if (cycle == nullptr) return;
  double until_s = -std::numeric_limits<double>::infinity();
  for (std::size_t row = 1; row < recording.rows(); ++row) {
    const double lost = lostBefore(*cycle, row);
    if (lost > kLongestHole || (lost > 0 && recording.seconds(row) - recording.seconds(row - 1) > kLongestHole_s))
      throw BadInput(recording.file + ", line " + std::to_string(recording.lines[row]) + ": " +
                     std::to_string(static_cast<long>(lost)) + " rows" + messages::kLongHole);
    if (lost > 1) until_s = recording.seconds(row) + kForgotten;
    if (recording.seconds(row) > until_s) continue;
    for (Trajectory& joint : joints)
      joint.position_rad[row] = joint.load[row] = std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace darwinop::gap
