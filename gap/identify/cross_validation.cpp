#include "gap/identify/cross_validation.hpp"

#include <cmath>
#include <vector>

#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

Evidence leftOut(const Evidence& all, std::size_t left_out) {
  Evidence rest{.plant = all.plant, .given = all.given, .logs = {}, .noise = {}, .discrepancy = all.discrepancy};
  for (std::size_t i = 0; i < all.logs.size(); ++i) {
    if (i == left_out) continue;
    rest.logs.push_back(all.logs[i]);
    rest.noise.push_back(all.noise[i]);
  }
  return rest;
}

/// Mean |position error| of this log, rad, when the others alone are fitted.
double errorOn(const FittedModel& fitted, std::size_t left_out) {
  const Evidence rest = leftOut(*fitted.evidence, left_out);
  const Problem problem{rest, fitted.problem.hypothesis(), fitted.problem.unknowns()};
  const Fit fit =
      solve(problem, fitted.fit.x,
            {.iterations = thresholds::kCrossValidationIterations, .refine = false, .steps = fitted.fit.steps});
  const std::size_t log = fitted.evidence->logs[left_out];
  const Trajectory& measured = rest.given->logs[log];
  Trace trace;
  rest.plant->rollOut(*rest.given, log, problem.at(fit.x), {}, trace);
  double sum = 0;
  double count = 0;
  for (std::size_t row = 0; row < measured.rows(); ++row)
    if (const double error = measured.position_rad[row] - trace[kPositionSignal][row]; !std::isnan(error))
      sum += std::abs(error), ++count;
  return sum / count;
}

}  // namespace

std::vector<double> leaveOneOutErrors(const FittedModel& fitted) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < fitted.evidence->logs.size(); ++i) errors.push_back(errorOn(fitted, i));
  return errors;
}

CrossValidation crossValidate(const std::vector<double>& without, const std::vector<double>& with) {
  CrossValidation result{.mean = 0, .error = 0, .logs = static_cast<int>(with.size())};
  const auto count = static_cast<double>(with.size());
  for (std::size_t i = 0; i < with.size(); ++i) result.mean += std::log(without[i] / with[i]) / count;
  for (std::size_t i = 0; i < with.size(); ++i)
    result.error += std::pow(std::log(without[i] / with[i]) - result.mean, 2) / (count * (count - 1));
  result.error = std::sqrt(result.error);
  return result;
}

CrossValidation crossValidate(const FittedModel& without, const FittedModel& with) {
  return crossValidate(leaveOneOutErrors(without), leaveOneOutErrors(with));
}

}  // namespace darwinop::gap
