#include "gap/case/repeat_spread.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/case/plausible.hpp"

namespace darwinop::gap {
namespace {

constexpr double kSameRow = 2e-3;  // s by which rows of two runs may differ

}  // namespace

std::vector<double> alignedTo(const Trajectory& first, const Trajectory& run) {
  std::vector<double> aligned(first.rows(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0, j = 0; i < first.rows(); ++i) {
    const double t = first.time_s[i] - first.time_s.front() + run.time_s.front();
    while (j + 1 < run.rows() && std::abs(run.time_s[j + 1] - t) <= std::abs(run.time_s[j] - t)) ++j;
    if (std::abs(run.time_s[j] - t) <= kSameRow) aligned[i] = run.position_rad[j];
  }
  return aligned;
}

double RunSpread::rms_rad() const {
  return freedom > 0 ? std::sqrt(square_sum / freedom) : std::numeric_limits<double>::quiet_NaN();
}

RunSpread spreadOf(const std::vector<const Trajectory*>& runs) {
  std::vector<std::vector<double>> positions;
  for (const Trajectory* const run : runs) positions.push_back(alignedTo(*runs.front(), *run));
  const auto count = static_cast<double>(runs.size());
  RunSpread spread;
  for (std::size_t row = 0; row < runs.front()->rows(); ++row) {
    double mean = 0, squares = 0;
    for (const auto& run : positions) mean += run[row] / count;
    for (const auto& run : positions) squares += (run[row] - mean) * (run[row] - mean);
    if (!std::isnan(squares)) spread.add({squares, count - 1});  // else masked, or a hole in time
  }
  return spread;
}

std::vector<std::vector<std::size_t>> repeatGroups(const Case& c, const std::vector<std::size_t>& among) {
  const auto copies = duplicates(c);
  const auto counts = [&](std::size_t i) {
    return !copies[i] && (among.empty() || std::ranges::find(among, i) != among.end());
  };
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t first = 0; first < c.logs.size(); ++first) {
    std::vector<std::size_t> group;
    for (std::size_t i = 0; i < c.logs.size(); ++i)
      if (counts(i) && (i == first || c.logs[i].repeat_of == first)) group.push_back(i);
    if (group.size() > 1) groups.push_back(std::move(group));
  }
  return groups;
}

RunSpread repeatSpread(const Case& c) {
  RunSpread all;
  for (const std::vector<std::size_t>& group : repeatGroups(c)) {
    std::vector<const Trajectory*> runs;
    for (const std::size_t log : group) runs.push_back(&c.logs[log]);
    all.add(spreadOf(runs));
  }
  return all;
}

}  // namespace darwinop::gap
