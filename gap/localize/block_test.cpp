#include "gap/localize/block_test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "gap/fit/problem.hpp"
#include "gap/localize/absorb.hpp"
#include "gap/localize/fit_nuisances.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

double square(double x) {
  return std::isnan(x) ? 0 : x * x;
}

/// Mean square of the copies' residuals around each sample, without copy `without`.
Eigen::VectorXd spreadOf(const std::vector<BlockResiduals>& copies, std::size_t without) {
  const Eigen::Index n = copies.front().residual.size();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(n), count = Eigen::VectorXd::Zero(n);
  for (std::size_t run = 0; run < copies.size(); ++run) {
    if (run == without) continue;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double r = copies[run].residual[i];
      if (std::isnan(r)) continue;
      for (Eigen::Index j = std::max<Eigen::Index>(0, i - thresholds::kRepeatsHalfWindow);
           j <= std::min(n - 1, i + thresholds::kRepeatsHalfWindow); ++j)
        sum[j] += r * r, count[j] += 1;
    }
  }
  return (sum.array() / count.array().max(1)).matrix();
}

void standardise(BlockResiduals& samples, const Eigen::VectorXd& spread) {
  samples.sigma = samples.sigma.cwiseMax(spread.cwiseSqrt());
  for (Eigen::Index i = 0; i < samples.z.size(); ++i)
    samples.z[i] = std::isnan(samples.residual[i]) ? 0 : samples.residual[i] / samples.sigma[i];
}

/// Mean cost of one log, and that of its worst box.
struct LogCost {
  double mean = 0, worst = 0, count = 0;
};

LogCost costOfLog(const BlockResiduals& samples, const Trajectory& log) {
  LogCost out;
  double box = 0, in_box = 0, begun_s = log.time_s.front();
  const auto close = [&] {
    if (in_box >= 3) out.worst = std::max(out.worst, box / in_box);
    box = in_box = 0;
  };
  for (Eigen::Index i = 0; i < samples.z.size(); ++i) {
    if (std::isnan(samples.residual[i])) continue;
    const double cost = costOf(samples.z[i]), t = log.time_s[samples.row[static_cast<std::size_t>(i)]];
    if (t - begun_s > thresholds::kBlockBox) close(), begun_s = t;
    box += cost, in_box += 1;
    out.mean += cost, out.count += 1;
  }
  close();
  out.mean /= std::max(out.count, 1.0);
  return out;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Excess of the observed cost over the simulated copies, in standard deviations: the greatest of the logs, and of all
/// logs together. `copies`: one entry for each log, one value for each copy. The relative spread is pooled over the
/// logs, because the copies are few.
double beyond(const std::vector<double>& seen, const std::vector<std::vector<double>>& copies, double least_spread) {
  double square = 0, count = 0, greatest = 0, all_seen = 0, all_expected = 0;
  std::vector<double> means, together(copies.empty() ? 0 : copies.front().size());
  for (std::size_t i = 0; i < copies.size(); ++i) {
    means.push_back(sum(copies[i]) / static_cast<double>(copies[i].size()));
    if (!(means[i] > 0)) continue;
    for (std::size_t run = 0; run < copies[i].size(); ++run) {
      square += std::pow(copies[i][run] / means[i] - 1, 2), together[run] += copies[i][run];
    }
    count += static_cast<double>(copies[i].size() - 1);
    all_seen += seen[i], all_expected += means[i];
  }
  if (!(count > 0)) return 0;
  const double spread = std::max(std::sqrt(square / count), least_spread);
  for (std::size_t i = 0; i < copies.size(); ++i)
    if (means[i] > 0) greatest = std::max(greatest, (seen[i] / means[i] - 1) / spread);
  const double of_all = std::max(spread / std::sqrt(static_cast<double>(copies.size())), thresholds::kSpreadOfAll);
  return std::max(greatest, (all_seen / all_expected - 1) / of_all);
}

double rmsOf(const std::vector<BlockResiduals>& all) {
  double sum = 0, count = 0;
  for (const BlockResiduals& samples : all)
    for (const double r : samples.residual) sum += square(r), count += std::isnan(r) ? 0 : 1;
  return count > 0 ? std::sqrt(sum / count) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

bool BlockTest::known() const {
  return !std::isnan(rms);
}

bool BlockTest::isOpen() const {
  return significance > thresholds::kOpenSigmas || moved > thresholds::kMovedSigmas;
}

BlockTest judge(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                const SimulatedRepeats& copies, const Hypothesis& hypothesis, const std::vector<Unknown>& numbers) {
  BlockTest out;
  out.samples.resize(logs.size());
  std::vector<std::vector<BlockResiduals>> runs(logs.size(), std::vector<BlockResiduals>(copies.size()));
  forEach(logs.size() * (copies.size() + 1), [&](std::size_t task) {
    const std::size_t i = task / (copies.size() + 1), run = task % (copies.size() + 1);
    if (run == copies.size())
      out.samples[i] = cut(given.logs[logs[i]], hypothesis);
    else
      runs[i][run] = cut(copies[run][i], hypothesis);
  });
  out.rms = rmsOf(out.samples);
  double squares = 0, count = 0;
  std::vector<std::vector<double>> means(logs.size()), worsts(logs.size());
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const double rms = rmsOf(runs[i]), n = static_cast<double>(out.samples[i].residual.size());
    if (!std::isnan(rms)) squares += rms * rms * n, count += n;
    standardise(out.samples[i], spreadOf(runs[i], copies.size()));
    std::vector<Eigen::VectorXd> spreads;
    for (std::size_t run = 0; run < copies.size(); ++run) spreads.push_back(spreadOf(runs[i], run));
    for (std::size_t run = 0; run < copies.size(); ++run) {
      standardise(runs[i][run], spreads[run]);
      const LogCost cost = costOfLog(runs[i][run], copies[run][i]);
      means[i].push_back(cost.mean);
      worsts[i].push_back(cost.worst);
    }
  }
  out.expected_rms = count > 0 ? std::sqrt(squares / count) : std::numeric_limits<double>::quiet_NaN();
  if (!out.known()) return out;
  if (!numbers.empty()) out.moved = significanceOf(fitNuisances(cut, given, logs, hypothesis, numbers, out.samples));
  std::vector<double> seen_means, seen_worsts;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const LogCost seen = costOfLog(out.samples[i], given.logs[logs[i]]);
    seen_means.push_back(seen.mean);
    seen_worsts.push_back(seen.worst);
    out.cost += seen.mean * seen.count;
    out.expected_cost += sum(means[i]) / static_cast<double>(copies.size()) * seen.count;
  }
  out.significance = std::max(beyond(seen_means, means, thresholds::kSpreadOfLog),
                              beyond(seen_worsts, worsts, thresholds::kSpreadOfWorst));
  return out;
}

double blockCostUnder(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                      const BlockTest& judged, const Hypothesis& other) {
  double cost = 0;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const BlockResiduals there = cut(given.logs[logs[i]], other);
    for (Eigen::Index k = 0; k < there.residual.size(); ++k)
      if (!std::isnan(there.residual[k])) cost += costOf(there.residual[k] / judged.samples[i].sigma[k]);
  }
  return cost;
}

}  // namespace darwinop::gap
