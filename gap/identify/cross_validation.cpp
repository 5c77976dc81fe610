#include "gap/identify/cross_validation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "gap/parallel/parallel.hpp"
#include "gap/plant/registers.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// What is left of a fit's evidence without some of its logs.
struct Rest {
  Evidence evidence;
  std::vector<Eigen::Index> rows;  // of the fit's residuals

  Rest(const Evidence& all, const std::vector<std::size_t>& left_out)
      : evidence{.plant = all.plant, .given = all.given, .logs = {}, .noise = {}, .discrepancy = all.discrepancy} {
    const std::vector<Eigen::Index> first_row = all.firstRows();
    for (std::size_t i = 0; i < all.logs.size(); ++i) {
      if (std::ranges::find(left_out, i) != left_out.end()) continue;
      evidence.logs.push_back(all.logs[i]);
      evidence.noise.push_back(all.noise[i]);
      for (Eigen::Index row = 0; row < all.noise[i].size(); ++row) rows.push_back(first_row[i] + row);
    }
  }
};

/// The fit to all logs, without those effects that the other logs do not need: a fit to them would leave the numbers
/// where the left-out log has put them, and predict that log by itself.
Eigen::VectorXd startOf(const FittedModel& fitted, const Problem& others, const Eigen::VectorXd& residuals) {
  Eigen::VectorXd x = fitted.fit.x;
  const std::vector<std::size_t> order = others.costliestFirst(residuals);
  double cost = others.costUpTo(std::numeric_limits<double>::infinity(), x, order);  // summed alike: equal is equal
  for (const ChosenEffect& effect : fitted.effects) {
    const Eigen::VectorXd bare = takenOut(fitted, effect, x);
    if (const double without = others.costUpTo(cost, bare, order); without <= cost) x = bare, cost = without;
  }
  return x;
}

/// Mean |position error| over the rows of logs, rad.
class MeanError {
 public:
  void add(const Plant& plant, const Case& given, std::size_t log, const Hypothesis& model) {
    const Trajectory& measured = given.logs[log];
    Trace trace;
    plant.rollOut(given, log, model, {}, trace);
    for (std::size_t row = 0; row < measured.rows(); ++row)
      if (const double error = measured.position_rad[row] - trace[kPositionSignal][row]; !std::isnan(error))
        sum_ += std::abs(error), ++count_;
  }
  [[nodiscard]] double mean() const { return sum_ / count_; }

 private:
  double sum_ = 0, count_ = 0;
};

/// Mean |position error| of these logs, rad, when the others alone are fitted.
double errorOn(const FittedModel& fitted, const std::vector<std::size_t>& left_out) {
  const Rest rest{*fitted.evidence, left_out};
  const Problem problem{rest.evidence, fitted.problem.hypothesis(), fitted.problem.unknowns()};
  const Eigen::VectorXd start = startOf(fitted, problem, fitted.fit.residuals(rest.rows));
  SolveOptions options{
      .iterations = thresholds::kCrossValidationIterations, .refine = false, .steps = fitted.fit.steps};
  if (fitted.fit.jacobian.size() != 0 && start == fitted.fit.x)
    options.jacobian = fitted.fit.jacobian(rest.rows, Eigen::all);
  const Fit fit = solve(problem, start, options);
  MeanError error;
  for (const std::size_t one : left_out)
    error.add(*rest.evidence.plant, *rest.evidence.given, fitted.evidence->logs[one], problem.at(fit.x));
  return error.mean();
}

}  // namespace

std::vector<std::vector<std::size_t>> independentLogs(const Evidence& evidence) {
  std::vector<std::vector<std::size_t>> groups;
  std::vector<std::size_t> first;  // log of the case, of each group
  for (std::size_t i = 0; i < evidence.logs.size(); ++i) {
    const std::size_t of = evidence.given->logs[evidence.logs[i]].repeat_of.value_or(evidence.logs[i]);
    const auto found = static_cast<std::size_t>(std::ranges::find(first, of) - first.begin());
    if (found == first.size()) first.push_back(of), groups.emplace_back();
    groups[found].push_back(i);
  }
  return groups;
}

std::vector<double> leaveOneOutErrors(const FittedModel& fitted) {
  const std::vector<std::vector<std::size_t>> groups = independentLogs(*fitted.evidence);
  std::vector<double> errors(groups.size());
  forEach(groups.size(), [&](std::size_t i) { errors[i] = errorOn(fitted, groups[i]); });
  return errors;
}

std::vector<double> predictionErrors(const Plant& plant, const Case& logs, const Hypothesis& model) {
  std::vector<double> errors(logs.logs.size());
  forEach(errors.size(), [&](std::size_t i) {
    try {
      MeanError error;
      error.add(plant, logs, i, model);
      errors[i] = error.mean();
    } catch (const std::runtime_error&) {  // an arm that is too light for the inertia that was fitted
      errors[i] = std::numbers::pi;
    }
  });
  return errors;
}

CrossValidation crossValidate(const std::vector<double>& without, const std::vector<double>& with, double floor_rad) {
  CrossValidation result{.mean = 0, .error = 0, .logs = static_cast<int>(with.size())};
  const auto count = static_cast<double>(with.size());
  const auto ratio = [&](std::size_t i) {
    return std::log(std::hypot(without[i], floor_rad) / std::hypot(with[i], floor_rad));
  };
  for (std::size_t i = 0; i < with.size(); ++i) result.mean += ratio(i) / count;
  for (std::size_t i = 0; i < with.size(); ++i)
    result.error += std::pow(ratio(i) - result.mean, 2) / (count * (count - 1));
  result.error = std::sqrt(result.error);
  return result;
}

CrossValidation crossValidate(const FittedModel& without, const FittedModel& with) {
  return crossValidate(leaveOneOutErrors(without), leaveOneOutErrors(with),
                       readingSigma(without.study->data.model.servo));
}

}  // namespace darwinop::gap
