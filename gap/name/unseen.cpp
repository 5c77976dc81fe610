#include "gap/name/unseen.hpp"

#include <cmath>
#include <vector>

namespace darwinop::gap {
namespace {

constexpr int kIterations = 6;  // from where all logs together wanted to be

Evidence leftOut(const Evidence& all, std::size_t left_out) {
  Evidence rest{.given = all.given, .logs = {}, .noise = {}};
  for (std::size_t i = 0; i < all.logs.size(); ++i) {
    if (i == left_out) continue;
    rest.logs.push_back(all.logs[i]);
    rest.noise.push_back(all.noise[i]);
  }
  return rest;
}

/// Position error of this log, rms, rad, when the others alone are fitted.
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
    sum += std::pow(measured.position_rad[row] - trace.position_rad[row], 2);
  return std::sqrt(sum / static_cast<double>(measured.rows()));
}

}  // namespace

Foretold foretold(const Settled& without, const Settled& with) {
  std::vector<double> gains;
  for (std::size_t i = 0; i < with.evidence->logs.size(); ++i)
    gains.push_back(std::log(errorOn(without, i) / errorOn(with, i)));
  Foretold told{.mean = 0, .error = 0, .logs = static_cast<int>(gains.size())};
  const auto count = static_cast<double>(gains.size());
  for (const double gain : gains) told.mean += gain / count;
  for (const double gain : gains) told.error += std::pow(gain - told.mean, 2) / (count * (count - 1));
  told.error = std::sqrt(told.error);
  return told;
}

}  // namespace darwinop::gap
