// A fitted explanation of the case, with its uncertainty, that a planned experiment is to test.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "gap/fit/discrepancy.hpp"
#include "gap/fit/unknown.hpp"

namespace darwinop::gap {

struct FittedHypothesis {
  std::string name;       // "backlash", "coulomb + viscous"
  Hypothesis hypothesis;  // before the unknowns are put in
  std::vector<Unknown> unknowns;
  Eigen::VectorXd x;             // search variables, as the logs of the case have them
  Eigen::MatrixXd information;   // inverse of the covariance of x: logs, priors, and that a number stays in its range
  double cost = 0;               // of the fit
  Discrepancy discrepancy = {};  // what it leaves on the logs of a roughly known servo, and will on others

  [[nodiscard]] Hypothesis at(const Eigen::VectorXd& where) const {
    return applied(hypothesis, unknowns, where.data());
  }
  [[nodiscard]] Hypothesis best() const { return at(x); }
  /// Standard deviations of x.
  [[nodiscard]] Eigen::VectorXd sigmas() const;
};

/// `jacobian`: of residuals in units of their noise, one column for each unknown; no rows: nothing was measured.
Eigen::MatrixXd informationOf(const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x,
                              const Eigen::MatrixXd& jacobian);

/// Nothing added to the baseline.
inline constexpr std::string_view kNothing = "nothing missing";

/// Fits each set of effects (ids, may be empty) to the case, alone. Logs that are copies of others count once. Throws
/// std::runtime_error for an id that the catalogue does not have, or that this baseline cannot lack.
std::vector<FittedHypothesis> fitHypotheses(const Case& given, const std::vector<std::vector<std::string>>& sets,
                                            const std::function<void(const std::string&)>& progress);

}  // namespace darwinop::gap
