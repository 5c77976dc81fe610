// Whether each log by itself agrees with an effect that all logs together suggest.
#pragma once

#include <cstddef>
#include <vector>

#include "gap/localize/body/clamped_robot.hpp"

namespace darwinop::gap {

/// Evidence of one log for an effect. For a quadratic cost, a true effect is expected to gain `change`, and an effect
/// that is absent to lose as much.
struct LogGain {
  double gain = 0, change = 0;   // reduction of the robust cost; squared change of the residuals
  double expected = 0;           // `change` with robust weights: lower bound of the gain of a true effect
  double cost = 0, samples = 0;  // robust cost with the effect, and the residuals behind it

  LogGain& operator+=(const LogGain& other);
  /// `rows_alike`: number of correlated residuals that count as one.
  LogGain& operator/=(double rows_alike);
  /// Cost per sample of the better of both models; at least 1, which is that of a true model.
  [[nodiscard]] double remainder() const;
  /// The change is large enough, beside the remainder, for the log to support or refute the effect.
  [[nodiscard]] bool decides() const;
};

/// The log shows that the effect stands for something else, such as chaos of a release in another log.
bool refutes(const LogGain& log);

/// The log shows the effect.
bool supports(const LogGain& log);

/// From whitened residuals without and with the effect.
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
