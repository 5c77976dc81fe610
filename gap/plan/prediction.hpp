// Predictions of one hypothesis for planned logs, with their sensitivity to its parameters.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gap/fit/noise.hpp"
#include "gap/plan/fitted_hypothesis.hpp"

namespace darwinop::gap {

inline constexpr int kNoiseRuns = 24;

struct Prediction {
  std::vector<Trace> expected;            // one a log
  std::vector<std::vector<Trace>> moved;  // the same with one unknown moved by its step; one a unknown
  Eigen::VectorXd steps;                  // of the search variables; about a standard deviation
  std::vector<LogNoise> noise;            // one a log; empty: not asked for

  [[nodiscard]] Eigen::Index size() const;
};

/// `coming`: of planned(). Throws std::runtime_error for an explanation that cannot be.
/// `noise_runs`: of each log; as many things may be off together. 0: no noise.
Prediction predict(const Case& coming, const FittedHypothesis& contender, int noise_runs);

/// At least one of the two has its noise. In sigma: how surely logs that `a` made are told from logs that `b` made,
/// after both have moved their numbers as far as the present logs and priors let them. Half of its square is the
/// expected difference of log likelihood.
double separationOf(const Case& coming, const FittedHypothesis& a, const Prediction& of_a, const FittedHypothesis& b,
                    const Prediction& of_b);

/// What the planned logs would add to the contender's information.
Eigen::MatrixXd informationFrom(const Case& coming, const Prediction& foresight);

}  // namespace darwinop::gap
