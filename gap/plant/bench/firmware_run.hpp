// The servo's firmware, run on the measured positions: the duty it would have commanded.
#pragma once

#include <vector>

#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// One value a firmware period; index 0 is the period that ends with the log's first row.
struct FirmwareRun {
  double period_s = 0;
  std::vector<double> duty, speed_rad_s;  // of law voltage_p, and of speed_p
  std::vector<double> supply_v;           // at the motor, under the hypothesis
  std::vector<double> position_rad;       // measured, between the rows on a straight line
  std::vector<std::size_t> row;           // the row whose commands are in force
  std::vector<std::size_t> last;          // one a row: the last period before this row's read

  [[nodiscard]] std::size_t periods() const { return duty.size(); }
};

FirmwareRun runFirmware(const Case& given, const Trajectory& log, const Hypothesis& hypothesis);

/// Commands of which row are in force right after the read of `row`.
std::size_t commandsAfter(const Case& given, const Trajectory& log, std::size_t row);

/// Temperature that counts for a row, degC: smoothed where it is; that of a room where the log has none.
double temperatureOf(const Trajectory& log, std::size_t row);

}  // namespace darwinop::gap
