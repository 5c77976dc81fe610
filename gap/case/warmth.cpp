// A temperature register steps by one degree; the servo does not. A straight line through the readings of some seconds
// around each instant, also of neighbouring logs, follows the servo to a few tenths of a degree.
#include <algorithm>
#include <cmath>
#include <vector>

#include "gap/case/parts.hpp"

namespace darwinop::gap {
namespace {

constexpr double kReach = 6;    // s, on either side; a servo takes half a minute and more to warm up
constexpr double kEvery = 0.1;  // s; a reading that often is enough
constexpr double kWithin = 1;   // degC, of the reading: the line is never farther off

struct Reading {
  double time_s, temp_c;
};

/// Logs of one session have distinct times in it.
bool isOneSession(const Case& of) {
  std::vector<std::pair<double, double>> spans;
  for (const Trajectory& log : of.logs)
    if (log.rows() > 0) spans.emplace_back(log.session_start_s, log.session_start_s + log.duration_s());
  std::ranges::sort(spans);
  for (std::size_t i = 1; i < spans.size(); ++i)
    if (spans[i].first < spans[i - 1].second) return false;
  return true;
}

void append(const Trajectory& log, std::vector<Reading>& readings) {
  double next_s = 0;
  for (std::size_t row = 0; row < log.rows(); ++row) {
    const double since_s = log.time_s[row] - log.time_s.front();
    if (std::isnan(log.temp_c[row]) || since_s < next_s) continue;
    readings.push_back({log.session_start_s + since_s, log.temp_c[row]});
    next_s = since_s + kEvery;
  }
}

/// Of a line through the readings around `time_s`, the nearer ones counting more; NaN: there are none.
double lineAt(double time_s, const std::vector<Reading>& readings) {
  double n = 0, st = 0, sv = 0, stt = 0, stv = 0;
  for (const Reading& reading : readings) {
    const double t = reading.time_s - time_s, share = std::abs(t) / kReach;
    if (share >= 1) continue;
    const double weight = std::pow(1 - share * share * share, 3);
    n += weight, st += weight * t, sv += weight * reading.temp_c;
    stt += weight * t * t, stv += weight * t * reading.temp_c;
  }
  if (n == 0) return std::nan("");
  const double spread = stt - st * st / n;
  const double slope = spread > 1e-3 * n ? (stv - st * sv / n) / spread : 0;
  return (sv - slope * st) / n;
}

/// Of each row: its own reading, or that of the row nearest in time. A servo is polled once in many rows.
std::vector<double> nearestReadings(const Trajectory& log) {
  std::vector<std::size_t> read;
  for (std::size_t row = 0; row < log.rows(); ++row)
    if (!std::isnan(log.temp_c[row])) read.push_back(row);
  std::vector<double> nearest(log.rows());
  for (std::size_t row = 0, i = 0; row < log.rows(); ++row) {
    const auto apart = [&](std::size_t k) { return std::abs(log.time_s[read[k]] - log.time_s[row]); };
    while (i + 1 < read.size() && apart(i + 1) <= apart(i)) ++i;
    nearest[row] = log.temp_c[read[i]];
  }
  return nearest;
}

}  // namespace

void smoothTemperatures(Case& of) {
  const bool together = isOneSession(of);
  std::vector<Reading> all;
  for (const Trajectory& log : of.logs) append(log, all);
  for (Trajectory& log : of.logs) {
    std::vector<Reading> own;
    append(log, own);
    log.warmth_c = log.temp_c;
    if (own.empty()) continue;
    const std::vector<double> nearest_c = nearestReadings(log);
    double known_at_s = -kEvery, known_c = std::nan("");
    for (std::size_t row = 0; row < log.rows(); ++row) {
      const double since_s = log.time_s[row] - log.time_s.front();
      if (since_s >= known_at_s + kEvery) {
        known_at_s = since_s;
        known_c = lineAt(log.session_start_s + since_s, together ? all : own);
      }
      const double line_c = std::isnan(known_c) ? nearest_c[row] : known_c;
      log.warmth_c[row] = std::clamp(line_c, nearest_c[row] - kWithin, nearest_c[row] + kWithin);
    }
  }
}

}  // namespace darwinop::gap
