#include "gap/localize/regions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "gap/localize/state_samples.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Upper ends of bins with about as many samples in each; one a value where there are few.
std::vector<double> binsOf(std::vector<double> values, std::size_t count) {
  std::ranges::sort(values);
  const std::set<double> distinct(values.begin(), values.end());
  if (distinct.size() <= count) return {distinct.begin(), distinct.end()};
  std::set<double> ends;
  for (std::size_t i = 1; i <= count; ++i) ends.insert(values[i * values.size() / count - 1]);
  return {ends.begin(), ends.end()};
}

std::size_t binOf(const std::vector<double>& ends, double value) {
  return std::min<std::size_t>(static_cast<std::size_t>(std::ranges::lower_bound(ends, value) - ends.begin()),
                               ends.size() - 1);
}

Region regionOf(const std::vector<StateSample>& samples, std::size_t variable, const std::vector<double>& levels) {
  Region region{.variable = stateVariables()[variable].name, .unit = stateVariables()[variable].unit};
  std::vector<double> values;
  for (const StateSample& sample : samples)
    if (!std::isnan(sample.state[variable])) values.push_back(sample.state[variable]);
  if (values.size() < 2 * thresholds::kFewestInBin) return region;
  const std::vector<double> ends = binsOf(values, thresholds::kStateBins);
  std::vector<std::array<double, thresholds::kResidualLevels>> count(ends.size(),
                                                                     std::array<double, thresholds::kResidualLevels>{});
  std::vector<double> energy(ends.size());
  std::array<double, thresholds::kResidualLevels> level_count{};
  double all_energy = 0;
  for (const StateSample& sample : samples) {
    if (std::isnan(sample.state[variable])) continue;
    const std::size_t bin = binOf(ends, sample.state[variable]), level = binOf(levels, sample.z);
    count[bin][level] += 1, level_count[level] += 1;
    energy[bin] += sample.z * sample.z, all_energy += sample.z * sample.z;
  }
  const double n = static_cast<double>(values.size());
  for (std::size_t bin = 0; bin < ends.size(); ++bin) {
    const double in_bin = std::accumulate(count[bin].begin(), count[bin].end(), 0.0);
    for (std::size_t level = 0; level < thresholds::kResidualLevels; ++level)
      if (count[bin][level] > 0)
        region.information += count[bin][level] / n * std::log2(count[bin][level] * n / in_bin / level_count[level]);
    const double lift = in_bin > 0 ? energy[bin] / in_bin / (all_energy / n) : 0;
    if (in_bin >= thresholds::kFewestInBin && lift > region.lift) {
      region.lift = lift;
      region.high = ends[bin];
      region.low = bin > 0 ? ends[bin - 1] : *std::ranges::min_element(values);
      if (ends.size() < thresholds::kStateBins) region.low = region.high;  // single values
    }
  }
  // Miller and Madow 1955: expected information by chance.
  region.information -=
      static_cast<double>((ends.size() - 1) * (thresholds::kResidualLevels - 1)) / (2 * n * std::log(2.0));
  region.information = std::max(0.0, region.information);
  return region;
}

/// Share of the variance of `y` that lies between groups, less what chance gives.
double betweenGroups(const std::vector<double>& y, const std::vector<int>& group) {
  std::map<int, std::pair<double, double>> sums;
  double total = 0, mean = std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    sums[group[i]].first += y[i], sums[group[i]].second += 1;
    total += (y[i] - mean) * (y[i] - mean);
  }
  if (!(total > 0) || sums.size() >= y.size()) return 0;
  double between = 0;
  for (const auto& [key, sum] : sums) between += sum.second * std::pow(sum.first / sum.second - mean, 2);
  const double n = static_cast<double>(y.size()), groups = static_cast<double>(sums.size());
  const double within = (total - between) / (n - groups);
  return std::max(0.0, (between - (groups - 1) * within) / total);
}

/// State: position and speed. Clock: a third of the session, within one cell of the state; none where a log has no
/// session time. Masked rows have no cell.
void stateOrClock(const std::vector<StateSample>& samples, Dependence& out) {
  const auto is_masked = [](const StateSample& sample) { return std::isnan(sample.state[kPositionState]); };
  std::vector<double> position, speed, session;
  for (const StateSample& sample : samples) {
    if (is_masked(sample)) continue;
    position.push_back(sample.state[kPositionState]);
    speed.push_back(sample.state[kSpeedState]);
    session.push_back(sample.state[kSessionState]);
  }
  out.is_clock_known = std::ranges::none_of(session, [](double time_s) { return std::isnan(time_s); });
  if (!out.is_clock_known) std::ranges::fill(session, 0);
  const auto q = binsOf(position, 6), w = binsOf(speed, 3), t = binsOf(session, 3);
  std::vector<double> y[2];  // signed, and how large
  std::vector<int> cell, both;
  for (const StateSample& sample : samples) {
    if (is_masked(sample)) continue;
    const std::size_t direction = sample.state[2] > 0 ? 2 : sample.state[2] < 0 ? 1 : 0;
    cell.push_back(static_cast<int>(
        (binOf(q, sample.state[kPositionState]) * 3 + binOf(w, sample.state[kSpeedState])) * 3 + direction));
    both.push_back(cell.back() * 3 + static_cast<int>(binOf(t, session[both.size()])));
    y[0].push_back(std::asinh(sample.z));
    y[1].push_back(std::log1p(sample.z * sample.z));
  }
  for (const auto& values : y) {
    const double by_state = betweenGroups(values, cell), by_both = betweenGroups(values, both);
    out.by_state = std::max(out.by_state, by_state);
    out.by_clock = std::max(out.by_clock, by_both - by_state);
  }
  const bool state = out.by_state > thresholds::kDependenceShare, clock = out.by_clock > thresholds::kDependenceShare;
  out.on = state && clock ? Depends::kBoth : state ? Depends::kState : clock ? Depends::kClock : Depends::kNothing;
}

}  // namespace

std::string_view name(Depends depends) {
  switch (depends) {
    case Depends::kState:
      return "state";
    case Depends::kClock:
      return "clock";
    case Depends::kBoth:
      return "state and clock";
    case Depends::kNothing:
      break;
  }
  return "nothing";
}

Dependence dependenceOf(const Case& given, const std::vector<LogResidual>& residuals, const Blocks& blocks) {
  Dependence out{.of = "position", .regions = {}};
  std::vector<StateSample> samples;
  const BlockFinding* const open = blocks.first ? &blocks.of(*blocks.first) : nullptr;
  if (open != nullptr && !open->samples.empty()) out.of = name(open->block);
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const Trajectory& log = given.logs[residuals[i].log];
    if (out.of != "position") {
      addSamples(log, open->samples[i].z, open->samples[i].row, samples);
      continue;
    }
    std::vector<std::size_t> rows(log.rows());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    addSamples(log, residuals[i].z, rows, samples);
  }
  if (samples.size() < 2 * thresholds::kFewestInBin) return out;
  std::vector<double> z;
  z.reserve(samples.size());
  for (const StateSample& sample : samples) z.push_back(sample.z);
  const std::vector<double> levels = binsOf(z, thresholds::kResidualLevels);
  for (std::size_t variable = 0; variable < stateVariables().size(); ++variable)
    out.regions.push_back(regionOf(samples, variable, levels));
  std::ranges::stable_sort(out.regions, std::greater{}, &Region::information);
  stateOrClock(samples, out);
  return out;
}

}  // namespace darwinop::gap
