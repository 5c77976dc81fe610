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
  std::vector<LogNoise> noise;            // one a log; empty: not computed

  [[nodiscard]] Eigen::Index size() const;
};

/// `coming`: of planned(). Throws std::runtime_error for a hypothesis that is physically impossible.
/// `noise_runs`: simulations of each log, which bound the rank of its noise. 0: no noise.
Prediction predict(const Case& coming, const FittedHypothesis& hypothesis, int noise_runs);

/// In sigma: how well the planned logs distinguish `a` from `b`, after both have adjusted their parameters as far as
/// the present logs and priors allow. Half of its square is the expected difference of log likelihood. At least one of
/// the two predictions needs its noise.
double separationOf(const Case& coming, const FittedHypothesis& a, const Prediction& of_a, const FittedHypothesis& b,
                    const Prediction& of_b);

/// What the planned logs would add to the information of a hypothesis.
Eigen::MatrixXd informationFrom(const Case& coming, const Prediction& prediction);

}  // namespace darwinop::gap
