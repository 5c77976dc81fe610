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
  double expected = 0;           // gain of a right effect: the change, as the robust cost weighs it
  double cost = 0, samples = 0;  // with the effect

  LogGain& operator+=(const LogGain& other);
  /// Of residuals of which so many count as one.
  LogGain& operator/=(double rows_alike);
  /// Of one sample, by what the better of both models leaves: 1, or more where neither is right.
  [[nodiscard]] double remainder() const;
  /// The effect changes more than what it leaves may be mistaken for.
  [[nodiscard]] bool decides() const;
};

/// The log shows that the effect stands for something else, such as chaos of a release in another log.
bool refutes(const LogGain& log);

/// The log shows the effect.
bool supports(const LogGain& log);

/// Between whitened residuals without the effect and with it.
LogGain gainOf(const Eigen::VectorXd& without, const Eigen::VectorXd& with);
/// All clamped logs of a limb together.
LogGain gainOf(const ClampedRobot& robot, std::size_t limb, const BodyHypothesis& without, const BodyHypothesis& with);
/// All held-out logs with a clamped trunk, under the noise of robots near `with`.
LogGain heldOutGain(const ClampedRobot& robot, std::size_t limb, const BodyHypothesis& without,
                    const BodyHypothesis& with);
/// A clamped log refutes the difference between two hypotheses about these limbs.
bool anyLogRefutes(const ClampedRobot& robot, const std::vector<std::size_t>& limbs, const BodyHypothesis& without,
                   const BodyHypothesis& with);

}  // namespace darwinop::gap
