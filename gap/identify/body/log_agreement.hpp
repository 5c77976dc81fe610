// Whether each log by itself agrees with an effect that all logs together suggest.
#pragma once

#include <cstddef>
#include <vector>

#include "gap/localize/body/clamped_robot.hpp"

namespace darwinop::gap {

/// Of one log: how much the cost of its residuals falls by an effect, and the square of their change. Where the effect
/// is right the one is expected to be the other; where nothing of it is there, the same with a minus.
struct LogGain {
  double gain = 0, change = 0;
};

/// The log shows that the effect stands for something else, such as chaos of a release in another log.
bool refutes(const LogGain& log);

/// The log shows the effect.
bool supports(const LogGain& log);

/// All clamped logs of a limb together.
LogGain gainOf(const ClampedRobot& robot, std::size_t limb, const BodyHypothesis& without, const BodyHypothesis& with);
/// All held-out logs with a clamped trunk, under the noise of robots near `with`.
LogGain heldOutGain(const ClampedRobot& robot, std::size_t limb, const BodyHypothesis& without,
                    const BodyHypothesis& with);
/// A clamped log refutes the difference between two hypotheses about these limbs.
bool anyLogRefutes(const ClampedRobot& robot, const std::vector<std::size_t>& limbs, const BodyHypothesis& without,
                   const BodyHypothesis& with);

}  // namespace darwinop::gap
