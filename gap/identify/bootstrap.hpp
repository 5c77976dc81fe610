// Parametric bootstrap: the logs as they would look if the present model were right. Gives the cost of a right model
// and the gain that the best effect is predicted by chance, so thresholds need no textbook value.
#pragma once

#include <vector>

#include "gap/identify/screen.hpp"

namespace darwinop::gap {

struct Bootstrap {
  double cost_mean = 0, cost_sigma = 0;  // of the residuals, without priors
  std::vector<double> chance_gains;      // greatest predicted gain of each replica, ascending
  std::vector<double> log_mean;          // cost of each log

  /// The predicted gain that only this share of replicas exceeds.
  [[nodiscard]] double threshold(double share) const;
};

/// Without a screen there are no chance gains.
Bootstrap bootstrapOf(const FittedModel& present, const Screen* screen, int count);

}  // namespace darwinop::gap
