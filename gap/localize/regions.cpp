#include "gap/localize/regions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "gap/plant/row_state.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// One sample: its residual and the state it is of.
struct Sample {
  double z = 0;
  std::vector<double> state;  // one a variable; NaN: not known
  int cell = 0;               // of position and speed, log class
};

struct Variable {
  const char* name;
  const char* unit;
  std::function<double(const Trajectory&, std::size_t row, double speed, double since)> value;
};

const std::vector<Variable>& variables() {
  static const std::vector<Variable> all{
      {"position", "rad", [](const auto& log, auto row, double, double) { return log.position_rad[row]; }},
      {"speed", "rad/s", [](const auto&, auto, double speed, double) { return std::abs(speed); }},
      {"direction", "",
       [](const auto&, auto, double speed, double) {
         return std::abs(speed) < thresholds::kDirectionSpeed ? 0 : std::copysign(1, speed);
       }},
      {"error", "rad",
       [](const auto& log, auto row, double, double) { return std::abs(log.goal_rad[row] - log.position_rad[row]); }},
      {"load", "", [](const auto& log, auto row, double, double) { return log.load[row]; }},
      {"temperature", "degC", [](const auto& log, auto row, double, double) { return log.temp_c[row]; }},
      {kSessionTime, "s",
       [](const auto& log, auto row, double, double) { return log.session_start_s + log.time_s[row] - log.time_s[0]; }},
      {"time since reversal", "s", [](const auto&, auto, double, double since) { return since; }},
      {"payload", "kg", [](const auto& log, auto, double, double) { return log.payload_kg; }},
      {"P register", "", [](const auto& log, auto, double, double) { return log.p_register; }},
      {"torque", "", [](const auto& log, auto row, double, double) { return log.torque_on[row] != 0 ? 1.0 : 0.0; }},
  };
  return all;
}
constexpr std::size_t kPosition = 0, kSpeed = 1, kSession = 6;

void addSamples(const Trajectory& log, const Eigen::VectorXd& z, const std::vector<std::size_t>& rows,
                std::vector<Sample>& into) {
  double turned_s = log.time_s.front(), direction = 0;
  std::vector<double> speed(log.rows()), since(log.rows());
  for (std::size_t row = 0; row < log.rows(); ++row) {
    speed[row] = stateAt(log, row).speed_rad_s;
    const double now = std::abs(speed[row]) < thresholds::kDirectionSpeed ? direction : std::copysign(1, speed[row]);
    if (now != direction) turned_s = log.time_s[row], direction = now;
    since[row] = log.time_s[row] - turned_s;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Sample sample{.z = z[static_cast<Eigen::Index>(i)], .state = {}, .cell = 0};
    for (const Variable& variable : variables())
      sample.state.push_back(variable.value(log, rows[i], speed[rows[i]], since[rows[i]]));
    into.push_back(std::move(sample));
  }
}

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

Region regionOf(const std::vector<Sample>& samples, std::size_t variable, const std::vector<double>& levels) {
  Region region{.variable = variables()[variable].name, .unit = variables()[variable].unit};
  std::vector<double> values;
  for (const Sample& sample : samples)
    if (!std::isnan(sample.state[variable])) values.push_back(sample.state[variable]);
  if (values.size() < 2 * thresholds::kFewestInBin) return region;
  const std::vector<double> ends = binsOf(values, thresholds::kStateBins);
  std::vector<std::array<double, thresholds::kResidualLevels>> count(ends.size(),
                                                                     std::array<double, thresholds::kResidualLevels>{});
  std::vector<double> energy(ends.size());
  std::array<double, thresholds::kResidualLevels> level_count{};
  double all_energy = 0;
  for (const Sample& sample : samples) {
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

/// State: position and speed. Clock: a third of the session, within one cell of the state.
void stateOrClock(const std::vector<Sample>& samples, Dependence& out) {
  std::vector<double> position, speed, session;
  for (const Sample& sample : samples) {
    position.push_back(sample.state[kPosition]);
    speed.push_back(sample.state[kSpeed]);
    session.push_back(sample.state[kSession]);
  }
  const auto q = binsOf(position, 6), w = binsOf(speed, 3), t = binsOf(session, 3);
  std::vector<double> y[2];  // signed, and how large
  std::vector<int> cell, both;
  for (const Sample& sample : samples) {
    const std::size_t direction = sample.state[2] > 0 ? 2 : sample.state[2] < 0 ? 1 : 0;
    cell.push_back(
        static_cast<int>((binOf(q, sample.state[kPosition]) * 3 + binOf(w, sample.state[kSpeed])) * 3 + direction));
    both.push_back(cell.back() * 3 + static_cast<int>(binOf(t, sample.state[kSession])));
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
  std::vector<Sample> samples;
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
  for (const Sample& sample : samples) z.push_back(sample.z);
  const std::vector<double> levels = binsOf(z, thresholds::kResidualLevels);
  for (std::size_t variable = 0; variable < variables().size(); ++variable)
    out.regions.push_back(regionOf(samples, variable, levels));
  std::ranges::stable_sort(out.regions, std::greater{}, &Region::information);
  stateOrClock(samples, out);
  return out;
}

}  // namespace darwinop::gap
