// What a model leaves over, taken for noise: a fit that will not get rid of it has to bear with it.
//
// Noise of a right model is a tick or two, and where the model stays wrong a fit by it bends everything for the few
// samples that noise disturbs least. Here all samples count alike, outliers little, and neighbours together as one.
#pragma once

#include <vector>

#include "gap/plant/bench/roll_out.hpp"

namespace darwinop::gap {

struct Discrepancy {
  double position_rad = 0;        // standard deviation, of what is not far off
  std::vector<double> load = {};  // rms, one a log of the case; a gain multiplies what the clocks differ by
  double correlation_s = 0;       // samples that near are off together; 0: nothing is left unexplained

  [[nodiscard]] bool any() const { return correlation_s > 0; }
};

/// What this hypothesis leaves of the logs with these indices.
Discrepancy discrepancyOf(const Case& given, const std::vector<std::size_t>& logs, const Hypothesis& hypothesis);

/// A residual in units of its noise, as large as its share of the cost: far ones count linearly.
double softened(double residual);

}  // namespace darwinop::gap
