#include "gap/report/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "gap/case/median.hpp"
#include "gap/case/plausible.hpp"
#include "gap/fit/noise.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plants.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Sums of squares of one log, or of several.
struct Squares {
  double before = 0, after = 0, floor = 0, rows = 0;

  void add(const Squares& other) {
    before += other.before, after += other.after, floor += other.floor, rows += other.rows;
  }
  [[nodiscard]] Gap rms() const {
    Gap gap;
    if (rows == 0) return gap;
    gap.before_rad = std::sqrt(before / rows);
    gap.after_rad = std::sqrt(after / rows);
    gap.floor_rad = std::sqrt(floor / rows);
    return gap;
  }
};

/// Masked values of `a` do not count.
double squareOf(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!std::isnan(a[i])) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

/// Rows whose position is not masked.
double knownRows(const Trajectory& log) {
  const auto masked = std::ranges::count_if(log.position_rad, [](double position) { return std::isnan(position); });
  return static_cast<double>(log.rows()) - static_cast<double>(masked);
}

/// Rms of the positions' residuals in units of the noise.
double shareOf(const LogNoise& noise, const Trajectory& log, const Trace& trace) {
  Eigen::VectorXd residuals(noise.size());
  noise.residuals(log, trace, residuals);
  const Eigen::Index positions = noise.size() / 2;  // loads follow
  return std::sqrt(residuals.head(positions).squaredNorm() / knownRows(log));
}

Squares compareOne(const Case& given, const Hypothesis& before, const Hypothesis& after, LogComparison& one) {
  const Trajectory& log = given.logs[one.log];
  const Plant& plant = plantOf(given);
  const LogNoise noise{plant, given, one.log, after, {}};
  Trace trace;
  plant.rollOut(given, one.log, before, {}, trace);
  one.before_rad = trace[kPositionSignal];
  plant.rollOut(given, one.log, after, {}, trace);
  one.after_rad = trace[kPositionSignal];
  Squares squares{.before = squareOf(log.position_rad, one.before_rad),
                  .after = squareOf(log.position_rad, one.after_rad),
                  .floor = noise.positionFloor().squares,
                  .rows = knownRows(log)};
  one.gap = squares.rms();
  one.noise_share = shareOf(noise, log, trace);
  one.below_floor =
      log.held_out && one.gap.after_rad < one.gap.floor_rad && one.noise_share < thresholds::kBelowFloorShare;
  return squares;
}

/// Without simulated noise, which would take longer than all the rest.
void compareOthers(const Case& given, const Hypothesis& before, const Hypothesis& after, Comparison& out) {
  Case view = given;
  view.logs.insert(view.logs.end(), view.others.begin(), view.others.end());
  const auto copies = duplicates(view);
  std::vector<Squares> squares(view.logs.size());
  forEach(view.others.size(), [&](std::size_t other) {
    const std::size_t i = given.logs.size() + other;
    if (copies[i]) return;
    const auto squareWith = [&](const Hypothesis& hypothesis) {
      Trace trace;
      plantOf(view).rollOut(view, i, hypothesis, {}, trace);
      return squareOf(view.logs[i].position_rad, trace[kPositionSignal]);
    };
    squares[i] = {.before = squareWith(before),
                  .after = squareWith(after),
                  .floor = std::numeric_limits<double>::quiet_NaN(),
                  .rows = knownRows(view.logs[i])};
  });
  Squares all;
  std::vector<double> errors;
  for (std::size_t i = given.logs.size(); i < squares.size(); ++i) {
    if (copies[i]) continue;
    all.add(squares[i]);
    ++out.other_logs;
    errors.push_back(squares[i].rms().after_rad);
    if (std::isnan(out.worst_other_rad) || errors.back() > out.worst_other_rad)
      out.worst_other_rad = errors.back(), out.worst_other = view.logs[i].file;
  }
  out.others = all.rms();
  out.median_other_rad = medianOf(errors);
}

}  // namespace

Gap::Gap() : before_rad{std::numeric_limits<double>::quiet_NaN()}, after_rad{before_rad}, floor_rad{before_rad} {}

Comparison::Comparison()
    : median_other_rad{std::numeric_limits<double>::quiet_NaN()}, worst_other_rad{median_other_rad} {}

bool Comparison::anyBelowFloor() const {
  return std::ranges::any_of(logs, &LogComparison::below_floor);
}

Comparison compare(const Case& given, const Hypothesis& before, const Hypothesis& after) {
  Comparison out;
  out.logs.resize(given.logs.size());
  std::vector<Squares> squares(given.logs.size());
  forEach(given.logs.size(), [&](std::size_t i) {
    out.logs[i].log = i;
    squares[i] = compareOne(given, before, after, out.logs[i]);
  });
  Squares held_out, fit;
  const auto copies = duplicates(given);
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (copies[i]) continue;
    (given.logs[i].held_out ? held_out : fit).add(squares[i]);
    ++(given.logs[i].held_out ? out.held_out_logs : out.fit_logs);
  }
  out.held_out = held_out.rms();
  out.fit = fit.rms();
  compareOthers(given, before, after, out);
  return out;
}

}  // namespace darwinop::gap
