#include "gap/name/unseen.hpp"

#include <cmath>
#include <vector>

namespace darwinop::gap {
namespace {

constexpr int kIterations = 6;  // from where all logs together wanted to be

Evidence leftOut(const Evidence& all, std::size_t left_out) {
  Evidence rest{.given = all.given, .logs = {}, .noise = {}, .unexplained = all.unexplained};
  for (std::size_t i = 0; i < all.logs.size(); ++i) {
    if (i == left_out) continue;
    rest.logs.push_back(all.logs[i]);
    rest.noise.push_back(all.noise[i]);
  }
  return rest;
}

/// Mean |position error| of this log, rad, when the others alone are fitted.
double errorOn(const Settled& fitted, std::size_t left_out) {
  const Evidence rest = leftOut(*fitted.evidence, left_out);
  const Problem problem{rest, fitted.problem.hypothesis(), fitted.problem.unknowns()};
  const Fit fit = solve(problem, fitted.fit.x, {.iterations = kIterations, .refine = false, .steps = fitted.fit.steps});
  const std::size_t log = fitted.evidence->logs[left_out];
  const Trajectory& measured = rest.given->logs[log];
  Trace trace;
  rollOut(*rest.given, log, problem.at(fit.x), {}, trace);
  double sum = 0;
  for (std::size_t row = 0; row < measured.rows(); ++row)
    sum += std::abs(measured.position_rad[row] - trace.position_rad[row]);
  return sum / static_cast<double>(measured.rows());
}

}  // namespace

std::vector<double> errorsUnseen(const Settled& fitted) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < fitted.evidence->logs.size(); ++i) errors.push_back(errorOn(fitted, i));
  return errors;
}

Foretold foretold(const std::vector<double>& without, const std::vector<double>& with) {
  Foretold told{.mean = 0, .error = 0, .logs = static_cast<int>(with.size())};
  const auto count = static_cast<double>(with.size());
  for (std::size_t i = 0; i < with.size(); ++i) told.mean += std::log(without[i] / with[i]) / count;
  for (std::size_t i = 0; i < with.size(); ++i)
    told.error += std::pow(std::log(without[i] / with[i]) - told.mean, 2) / (count * (count - 1));
  told.error = std::sqrt(told.error);
  return told;
}

Foretold foretold(const Settled& without, const Settled& with) {
  return foretold(errorsUnseen(without), errorsUnseen(with));
}

}  // namespace darwinop::gap
