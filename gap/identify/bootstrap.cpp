#include "gap/identify/bootstrap.hpp"

#include <algorithm>
#include <cmath>

#include "gap/parallel/parallel.hpp"
#include "gap/parallel/ranks.hpp"
#include "gap/plant/registers.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// The log as the servo would report it in this run.
Trajectory reportedLog(Trajectory log, const Trace& run) {
  const double step = loadStepOf(log);
  for (std::size_t row = 0; row < log.rows(); ++row) {
    if (!std::isnan(log.position_rad[row])) log.position_rad[row] = run[kPositionSignal][row];
    if (std::isfinite(log.load[row])) log.load[row] = std::round(run[kLoadSignal][row] / step) * step;
  }
  return log;
}

}  // namespace

double Bootstrap::threshold(double share) const {
  const auto last = static_cast<double>(chance_gains.size() - 1);
  return chance_gains[static_cast<std::size_t>(std::lround((1 - share) * last))];
}

Bootstrap bootstrapOf(const FittedModel& present, const Screen* screen, int count) {
  const Evidence& evidence = *present.evidence;
  const Hypothesis hypothesis = present.hypothesis();
  const auto logs = evidence.logs.size(), replicas = static_cast<std::size_t>(count);
  std::vector<Trace> quiet(logs);
  forEach(logs,
          [&](std::size_t i) { evidence.plant->rollOut(*evidence.given, evidence.logs[i], hypothesis, {}, quiet[i]); });

  // For each replica: greatest predicted gain, cost, cost of each log.
  const auto rows_of_replicas = sharedRows(replicas, 2 + logs, [&](std::size_t replica, std::span<double> out) {
    Eigen::VectorXd residuals(evidence.size());
    Eigen::Index row = 0;
    Trace noisy;
    for (std::size_t i = 0; i < logs; ++i) {
      Disturbance disturbance;
      disturbance.seed = thresholds::kBootstrapSeed + 1'000 * replica + i;
      evidence.plant->rollOut(*evidence.given, evidence.logs[i], hypothesis, {.disturbance = &disturbance}, noisy);
      const Eigen::Index rows = evidence.noise[i].size();
      evidence.noise[i].residuals(reportedLog(evidence.given->logs[evidence.logs[i]], noisy), quiet[i],
                                  residuals.segment(row, rows));
      out[2 + i] = residuals.segment(row, rows).unaryExpr(&costOf).sum();
      row += rows;
    }
    out[0] = screen != nullptr ? screen->greatestPredictedGain(residuals) : 0;
    out[1] = residuals.unaryExpr(&costOf).sum();
  });
  std::vector<double> chance_gains, costs;
  std::vector<std::vector<double>> log_costs;
  for (auto row = rows_of_replicas.begin(); row != rows_of_replicas.end();
       row += static_cast<std::ptrdiff_t>(2 + logs)) {
    chance_gains.push_back(row[0]);
    costs.push_back(row[1]);
    log_costs.emplace_back(row + 2, row + static_cast<std::ptrdiff_t>(2 + logs));
  }

  Bootstrap found{
      .cost_mean = 0, .cost_sigma = 0, .chance_gains = std::move(chance_gains), .log_mean = std::vector<double>(logs)};
  for (const double cost : costs) found.cost_mean += cost / count;
  for (const double cost : costs) found.cost_sigma += (cost - found.cost_mean) * (cost - found.cost_mean) / count;
  found.cost_sigma = std::sqrt(found.cost_sigma);
  for (const auto& of_logs : log_costs)
    for (std::size_t i = 0; i < logs; ++i) found.log_mean[i] += of_logs[i] / count;
  std::sort(found.chance_gains.begin(), found.chance_gains.end());
  return found;
}

}  // namespace darwinop::gap
