#include "gap/localize/body/clamped_robot.hpp"

#include <numeric>

#include "gap/parallel/parallel.hpp"
#include "gap/plant/body/joint_alone.hpp"

namespace darwinop::gap {

ClampedRobot::ClampedRobot(const BodyCase& given, bool has_board_supply)
    : given_{given},
      limbs_{limbsOf(given.joints.model)},
      baseline_{declaredRobot(given)},
      is_testable_{given.joints.model.servo.law == twin::Law::kVoltageP && !clampedLogs(given, false).empty()},
      residuals_(limbs_.size()) {
  baseline_.has_board_supply = baseline_.has_board_supply || has_board_supply;
  for (std::size_t limb = 0; limb < limbs_.size(); ++limb)
    for (const Link& link : limbs_[limb]) limb_of_[static_cast<std::size_t>(link.joint)] = limb;
  if (!is_testable_) return;
  std::vector<std::size_t> all(limbs_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  renew(all, baseline_);
}

void ClampedRobot::renew(const std::vector<std::size_t>& limbs, const BodyHypothesis& about) {
  forEach(limbs.size(), [&](std::size_t i) {
    residuals_[limbs[i]] = std::make_unique<LimbResiduals>(given_, clampedLogs(given_, false), limbs_[limbs[i]], about);
  });
}

}  // namespace darwinop::gap
