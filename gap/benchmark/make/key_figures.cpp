#include "gap/benchmark/make/key_figures.hpp"

#include <cmath>

namespace darwinop::gap {
namespace {

constexpr double kShows = 5e-3;    // rad, beyond any noise
constexpr double kTogether = 0.3;  // s; closer intervals are one

struct MeanSquare {
  double sum = 0;
  std::size_t count = 0;
  void add(const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    count += a.size();
  }
  [[nodiscard]] double root() const { return count == 0 ? std::nan("") : std::sqrt(sum / static_cast<double>(count)); }
};

/// Intervals of a log in which the two differ.
void addPlaces(const Trajectory& with, const Trajectory& without, std::vector<KeyPlace>& places) {
  bool fresh = true;
  for (std::size_t row = 0; row < with.rows(); ++row) {
    if (std::abs(with.position_rad[row] - without.position_rad[row]) < kShows) continue;
    const double t = with.time_s[row];
    if (fresh || t - places.back().to_s > kTogether) places.push_back({with.file, t, t});
    places.back().to_s = t;
    fresh = false;
  }
}

}  // namespace

void compare(const CasePlan& measured, const CasePlan& quiet, const Truth& truth, Key& key) {
  const Hypothesis baseline = baselineOf(measured.given);
  Truth known = truth;
  known.outside.clear();
  MeanSquare gap[2], noise[2];
  for (std::size_t i = 0; i < measured.given.logs.size(); ++i) {
    const Trajectory& log = measured.given.logs[i];
    Trace believed;
    rollOut(measured.given, i, baseline, {}, believed);
    gap[log.held_out ? 1 : 0].add(log.position_rad, believed[kPositionSignal]);
    noise[log.held_out ? 1 : 0].add(log.position_rad, quiet.given.logs[i].position_rad);
    if (truth.outside.empty() || log.held_out) continue;
    Trajectory without = log;
    measure(quiet, known, nullptr, without);
    addPlaces(quiet.given.logs[i], without, key.places);
  }
  key.gap_fit_rad = gap[0].root();
  key.gap_held_out_rad = gap[1].root();
  key.noise_fit_rad = noise[0].root();
  key.noise_held_out_rad = noise[1].root();
}

}  // namespace darwinop::gap
