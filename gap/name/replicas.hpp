// The logs as they would look if the present model were all there is: how well it would fit then, and what the best
// effect would promise by chance. Thresholds come from here, not from a textbook.
#pragma once

#include <vector>

#include "gap/name/screen.hpp"

namespace darwinop::gap {

inline constexpr int kReplicas = 200;

struct Replicas {
  double cost_mean = 0, cost_sigma = 0;  // of the residuals, without priors
  std::vector<double> promises;          // the greatest of each replica, rising
  std::vector<double> log_mean;          // cost of each log

  /// The promise that only this share of replicas exceeds.
  [[nodiscard]] double threshold(double share) const;
};

/// Without a screen there are no promises.
Replicas replicasOf(const Settled& present, const Screen* screen, int count);

}  // namespace darwinop::gap
