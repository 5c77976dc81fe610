#include "gap/localize/noise_floor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/case/repeat_spread.hpp"
#include "gap/plant/registers.hpp"

namespace darwinop::gap {
namespace {

/// Spread of the logs of one group: as measured, and the mean of all simulated repeats.
struct GroupSpread {
  RunSpread measured, simulated;
};

GroupSpread spreadOfGroup(const Case& given, const Evidence& evidence, const SimulatedRepeats& copies,
                          const std::vector<std::size_t>& group) {
  GroupSpread spread;
  std::vector<const Trajectory*> runs;
  for (const std::size_t log : group) runs.push_back(&given.logs[log]);
  spread.measured = spreadOf(runs);
  for (const std::vector<Trajectory>& copy : copies) {
    for (std::size_t i = 0; i < group.size(); ++i)
      runs[i] = &copy[static_cast<std::size_t>(std::ranges::find(evidence.logs, group[i]) - evidence.logs.begin())];
    spread.simulated.add(spreadOf(runs));
  }
  return spread;
}

}  // namespace

NoiseFloor floorOf(const Case& given, const Evidence& evidence, const SimulatedRepeats& copies) {
  NoiseFloor out;
  for (std::size_t i = 0; i < evidence.logs.size(); ++i) {
    LogFloor floor{.log = evidence.logs[i], .positions = evidence.noise[i].positionFloor()};
    floor.bifurcates = evidence.noise[i].bifurcates();
    floor.rms_rad = floor.positions.rms();
    floor.quantisation_rad = readingSigma(given.model.servo);
    floor.repeats_rad = floor.expected_rad = std::numeric_limits<double>::quiet_NaN();
    out.logs.push_back(std::move(floor));
  }
  RunSpread measured, simulated;
  for (const std::vector<std::size_t>& group : repeatGroups(given, evidence.logs)) {
    const GroupSpread spread = spreadOfGroup(given, evidence, copies, group);
    measured.add(spread.measured), simulated.add(spread.simulated);
    for (LogFloor& floor : out.logs)
      if (std::ranges::find(group, floor.log) != group.end())
        floor.repeats_rad = spread.measured.rms_rad(), floor.expected_rad = spread.simulated.rms_rad();
  }
  out.repeats_rad = repeatSpread(given).rms_rad();
  out.assumed = !(simulated.rms_rad() > 0);
  if (!out.assumed) out.factor = measured.rms_rad() / simulated.rms_rad();
  return out;
}

}  // namespace darwinop::gap
