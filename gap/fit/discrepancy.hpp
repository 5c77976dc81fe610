// Model discrepancy: the remaining error of a wrong model, treated as correlated noise.
//
// The noise of a right model is a tick or two. Under it a fit of a wrong model distorts every parameter for the
// few samples with the least noise. With a discrepancy all samples weigh the same, outliers little, and neighbours
// count as one.
#pragma once

#include <vector>

#include "gap/plant/plant.hpp"

namespace darwinop::gap {

struct Discrepancy {
  double position_rad = 0;        // robust standard deviation
  std::vector<double> load = {};  // rms, one for each log of the case
  double correlation_s = 0;       // correlation time; 0: no discrepancy

  [[nodiscard]] bool any() const { return correlation_s > 0; }
};

/// Of this hypothesis on the logs with these indices.
Discrepancy discrepancyOf(const Plant& plant, const Case& given, const std::vector<std::size_t>& logs,
                          const Hypothesis& hypothesis);

/// Signed root of the robust cost of a residual in standard deviations: large ones count linearly.
double softened(double residual);

}  // namespace darwinop::gap
