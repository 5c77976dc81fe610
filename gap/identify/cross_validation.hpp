// Prediction errors: of each fitted log by a fit to the others (leave-one-log-out), and of logs that no fit uses.
#pragma once

#include <vector>

#include "gap/identify/fitted_model.hpp"

namespace darwinop::gap {

/// Prediction error ratio of two models: mean over the logs of log(error without / error with), and its standard error.
struct CrossValidation {
  double mean = 0, error = 0;
  int logs = 0;

  static constexpr int kFewestLogs = 3;  // for a standard error
  /// The mean is positive by more than two standard errors. Among equal models that is chance in 9 % of cases with
  /// three logs, in 4 % with eight. Not the 4.5 of Student's t: an effect that shows in some logs only, as a speed
  /// limit, has ratios that differ much, and three logs would never do.
  [[nodiscard]] bool improves() const { return logs >= kFewestLogs && mean > 2 * error; }
  /// And exceeds `by` with 95 % confidence (one-sided, normal).
  [[nodiscard]] bool improvesBy(double by) const { return improves() && mean - by > 1.645 * error; }
};
CrossValidation crossValidate(const FittedModel& without, const FittedModel& with);
/// The same for errors that are known already. `floor_rad` is added to both, in quadrature: it is what the
/// encoder cannot resolve.
CrossValidation crossValidate(const std::vector<double>& without, const std::vector<double>& with, double floor_rad);

/// Fitted logs that repeat each other, as indices of the evidence: they are one piece of evidence.
std::vector<std::vector<std::size_t>> independentLogs(const Evidence& evidence);

/// Mean |position error| of each log, rad, when the other logs alone are fitted; of a log and its repeats together.
std::vector<double> leaveOneOutErrors(const FittedModel& fitted);

/// Mean |position error| of each of `logs`, rad, which no fit has used. Half a turn where the model cannot be
/// simulated.
std::vector<double> predictionErrors(const Plant& plant, const Case& logs, const Hypothesis& model);

}  // namespace darwinop::gap
