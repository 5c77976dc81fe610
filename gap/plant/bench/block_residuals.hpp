// Residuals of single blocks of the loop, from measured inputs and outputs. No closed loop is simulated.
#pragma once

#include <vector>

#include "gap/plant/block_residuals.hpp"

namespace darwinop::gap {

/// load - law(goal, position), as a duty. Only if the load register holds the duty.
BlockResiduals controllerResiduals(const Case& given, const Trajectory& log, const Hypothesis& hypothesis);

/// volt - what the supply should give, V.
BlockResiduals supplyResiduals(const Case& given, const Trajectory& log, const Hypothesis& hypothesis);
/// What the servo draws from its supply at each row, A: duty times motor current.
Eigen::VectorXd drawnCurrent(const Case& given, const Trajectory& log, const Hypothesis& hypothesis);

/// Slope of the voltage against that current, ohm; a constant offset of the voltage does not matter. NaN without
/// information.
double supplyResistance(const Case& given, const std::vector<const Trajectory*>& logs, const Hypothesis& hypothesis);

/// speed - difference of positions over the time that the servo takes, rad/s.
BlockResiduals sensorResiduals(const Trajectory& log, const Hypothesis& hypothesis);

/// Multiple shooting: windows start at a measured state, the mechanics of the hypothesis run with the measured load as
/// duty; residual is measured - simulated position at the end, rad. If the load is not a duty, the control law runs.
BlockResiduals shootingResiduals(const Case& given, const Trajectory& log, const Hypothesis& hypothesis,
                                 const ShootingOptions& options);

}  // namespace darwinop::gap
