// Position errors of two models on the same logs, beside the noise floor.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// Rms position errors of the closed loop, rad; NaN where there is no log.
struct Gap {
  double before_rad, after_rad;
  double floor_rad;  // of a right model: noise alone
  Gap();
  [[nodiscard]] double floorsBefore() const { return before_rad / floor_rad; }
  [[nodiscard]] double floorsAfter() const { return after_rad / floor_rad; }
};

struct LogComparison {
  std::size_t log = 0;  // index in the case
  Gap gap;
  // Residual of the second model in units of its noise: 1 for a right model.
  double noise_share = 1;
  bool below_floor = false;                   // held out, and closer to the data than noise permits
  std::vector<double> before_rad, after_rad;  // simulated positions, one a row
};

struct Comparison {
  std::vector<LogComparison> logs;  // all of the case
  // Over all rows of the held-out logs, of the fitted ones, and of those that are neither, whose noise is not
  // simulated. Copies of a log count once.
  Gap held_out, fit, others;
  std::size_t held_out_logs = 0, fit_logs = 0, other_logs = 0;
  // Of those that are neither, with the second model: rms error of the log in the middle, and of the worst.
  double median_other_rad, worst_other_rad;
  std::string worst_other;  // its file
  Comparison();
  [[nodiscard]] bool anyBelowFloor() const;
};

/// The noise is that of `after`. Deterministic.
Comparison compare(const Case& given, const Hypothesis& before, const Hypothesis& after);

}  // namespace darwinop::gap
