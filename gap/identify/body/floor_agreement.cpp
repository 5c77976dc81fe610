#include "gap/identify/body/floor_agreement.hpp"

#include <algorithm>

#include "gap/identify/body/mechanics_fit.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {

std::vector<LogGain> gainsOf(const FloorResiduals& about_with, const FloorTraces& without,
                             const ImuDeviation& imu_without, const ImuDeviation& imu_with) {
  const Eigen::VectorXd before = about_with.of(without, imu_without),
                        after = about_with.of(about_with.baseTraces(), imu_with);
  std::vector<LogGain> out;
  for (const FloorSamples& block : about_with.blocks()) {
    if (block.signal == 0) out.emplace_back();  // the first signal of a log
    out.back() += gainOf(before.segment(block.begin, block.rows), after.segment(block.begin, block.rows));
  }
  for (LogGain& log : out) log /= thresholds::kCorrelatedSamples;  // contacts of another engine are off for many rows
  return out;
}

bool refute(const std::vector<LogGain>& logs) {
  LogGain all;
  for (const LogGain& log : logs) all += log;
  return std::ranges::any_of(logs, refutes) || (all.decides() && all.gain < 0);
}

bool UnseenFloor::refute(const FloorModel& without, const FloorModel& with) const {
  const std::vector<std::size_t> logs = floorLogs(given_, true);
  if (logs.empty()) return false;
  const FloorResiduals residuals{given_, logs, imu_, with, ignored_};
  return gap::refute(gainsOf(residuals, residuals.simulate({without.robot}).front(), without.imu, with.imu));
}

}  // namespace darwinop::gap
