// Signals of a planned recording under a model of the whole robot, and how far two models differ in them.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "gap/localize/body/floor_residuals.hpp"

namespace darwinop::gap {

struct PredictedSignal {
  std::string name;            // "AnkleR.position"
  Eigen::VectorXd values;      // one a row; a resting sensor: one, the mean
  Eigen::VectorXd sigma = {};  // noise of each
  double rows_alike = 1;       // samples that count as one
};

/// Of one recording. Clamped: positions and loads of all joints and the resting sensor. Else: positions and the moving
/// sensor. `noise`: false: `sigma` is empty.
std::vector<PredictedSignal> predictedSignals(const BodyCase& coming, std::size_t log, const FloorModel& model,
                                              bool with_noise);

struct SignalDifference {
  double sigma = 0;     // of all signals together
  double floors = 0;    // rms difference over rms noise, of the signal where it is largest
  std::string largest;  // that signal
};

/// `a` has the noise. Where a simulation has failed nothing is compared.
SignalDifference differenceOf(const std::vector<PredictedSignal>& a, const std::vector<PredictedSignal>& b);

}  // namespace darwinop::gap
