// Residuals with the state of the joint that each of them belongs to.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "gap/plant/row_state.hpp"

namespace darwinop::gap {

/// One sample: its residual and the state it is of.
struct StateSample {
  double z = 0;
  std::vector<double> state;  // one a variable; NaN: not known
  int cell = 0;               // of position and speed, log class
};

struct StateVariable {
  const char* name;
  const char* unit;
  std::function<double(const Trajectory&, std::size_t row, double speed, double since)> value;
};

/// Their order is that of StateSample::state.
const std::vector<StateVariable>& stateVariables();
inline constexpr std::size_t kPositionState = 0, kSpeedState = 1, kSessionState = 6;

/// Appends the samples of these rows; `z` has one residual for each.
void addSamples(const Trajectory& log, const Eigen::VectorXd& z, const std::vector<std::size_t>& rows,
                std::vector<StateSample>& into);

}  // namespace darwinop::gap
