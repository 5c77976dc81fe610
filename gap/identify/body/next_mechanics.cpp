#include "gap/identify/body/next_mechanics.hpp"

#include <numeric>

#include "gap/thresholds.hpp"

namespace darwinop::gap {
std::vector<MechanicsEntry> nextMechanics(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                                          const std::vector<std::size_t>& open, const std::vector<double>& excess) {
  const std::vector<PlacedMechanics> now = effectsOf(found);
  if (open.size() == robot.limbs().size()) {
    std::vector<MechanicsEntry> common =
        fitted(robot, found, screenMechanics(robot, open, now, ScreenedPlaces::kAllJoints));
    const double sum = std::accumulate(excess.begin(), excess.end(), 0.0);
    if (!common.empty() && common.front().gain > thresholds::kExplainedGapShare * sum) return common;
  }
  return fitted(robot, found, screenMechanics(robot, open, now, ScreenedPlaces::kAny));
}

}  // namespace darwinop::gap
