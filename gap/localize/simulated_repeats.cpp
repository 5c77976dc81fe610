#include "gap/localize/simulated_repeats.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/conversions.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plant/registers.hpp"

namespace darwinop::gap {
namespace {

double toStep(double value, double step) {
  return std::round(value / step) * step;
}

/// How far the joint moved in the last `span_s` before a row; the speed goes on straight lines between rows.
double movedIn(const Trajectory& log, const Trace& trace, std::size_t row, double span_s) {
  double moved = 0;
  for (; row > 0 && span_s > 0; --row) {
    const double step_s = log.time_s[row] - log.time_s[row - 1], part_s = std::min(step_s, span_s);
    const double now = trace[kSpeedSignal][row], before = trace[kSpeedSignal][row - 1];
    moved += part_s * (now + 0.5 * (before - now) * part_s / step_s);
    span_s -= part_s;
  }
  return moved;
}

}  // namespace

Trajectory asReported(const Trajectory& log, const Trace& trace, double ticks_per_rev, std::uint64_t seed) {
  Trajectory out = log;
  std::mt19937_64 random{seed};
  std::uniform_real_distribution<double> phase{0, 1};
  const double tick = 2 * kPi / ticks_per_rev, load_step = loadStepOf(log);
  for (std::size_t row = 0; row < log.rows(); ++row) {
    if (!std::isnan(log.position_rad[row])) out.position_rad[row] = trace[kPositionSignal][row];
    if (!std::isnan(log.load[row])) out.load[row] = toStep(trace[kLoadSignal][row], load_step);
    if (!std::isnan(log.volt_v[row])) out.volt_v[row] = toStep(trace[kSupplySignal][row], kVoltStep);
    if (std::isnan(log.speed_rad_s[row])) continue;
    // The servo counts whole ticks, not those that it reports.
    const double ticks = std::floor(movedIn(log, trace, row, kSpeedSpan) / tick + phase(random));
    out.speed_rad_s[row] = toStep(ticks * tick / kSpeedSpan, kSpeedStep);
  }
  return out;
}

SimulatedRepeats simulateRepeats(const Plant& plant, const Case& given, const std::vector<std::size_t>& logs,
                                 const Hypothesis& hypothesis, int runs, std::uint64_t seed) {
  SimulatedRepeats copies(static_cast<std::size_t>(runs), std::vector<Trajectory>(logs.size()));
  forEach(copies.size() * logs.size(), [&](std::size_t i) {
    const std::size_t run = i / logs.size(), log = i % logs.size();
    Disturbance disturbance;
    disturbance.seed = (seed * 1'000 + run) * 1'000 + logs[log];
    Trace trace;
    plant.rollOut(given, logs[log], hypothesis, {.disturbance = &disturbance}, trace);
    copies[run][log] = asReported(given.logs[logs[log]], trace, hypothesis.servo.ticks_per_rev, disturbance.seed);
  });
  return copies;
}

}  // namespace darwinop::gap
