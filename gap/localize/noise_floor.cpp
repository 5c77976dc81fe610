#include "gap/localize/noise_floor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/plant/registers.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Rms of the difference over root 2, row by row by time since the first row; rows without partner do not count.
double differenceOf(const Trajectory& a, const Trajectory& b) {
  double sum = 0, count = 0;
  for (std::size_t i = 0, j = 0; i < a.rows(); ++i) {
    const double t = a.time_s[i] - a.time_s.front() + b.time_s.front();
    while (j + 1 < b.rows() && std::abs(b.time_s[j + 1] - t) <= std::abs(b.time_s[j] - t)) ++j;
    if (std::abs(b.time_s[j] - t) > thresholds::kSameRowTime) continue;
    const double d = a.position_rad[i] - b.position_rad[j];
    if (std::isnan(d)) continue;  // masked
    sum += d * d, count += 1;
  }
  return count > 0 ? std::sqrt(sum / count / 2) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

NoiseFloor floorOf(const Case& given, const Evidence& evidence, const SimulatedRepeats& copies) {
  NoiseFloor out;
  double measured = 0, expected = 0;
  for (std::size_t i = 0; i < evidence.logs.size(); ++i) {
    LogFloor floor{.log = evidence.logs[i], .sigma_rad = evidence.noise[i].positionSigma()};
    const Trajectory& log = given.logs[floor.log];
    floor.quantisation_rad = readingSigma(given.model.servo);
    floor.rms_rad = std::sqrt(floor.sigma_rad.squaredNorm() / static_cast<double>(floor.sigma_rad.size()));
    floor.repeats_rad = floor.expected_rad = std::numeric_limits<double>::quiet_NaN();
    const auto first = std::ranges::find(evidence.logs, log.repeat_of.value_or(given.logs.size()));
    if (first != evidence.logs.end()) {
      const Trajectory& other = given.logs[*first];
      if (const double difference = differenceOf(log, other); difference > 0) {  // a copy of a file is not a repeat
        floor.repeats_rad = difference;
        double sum = 0;
        const auto j = static_cast<std::size_t>(first - evidence.logs.begin());
        for (const auto& run : copies) sum += std::pow(differenceOf(run[i], run[j]), 2);
        floor.expected_rad = std::sqrt(sum / static_cast<double>(copies.size()));
        if (floor.expected_rad > 0) {
          measured += floor.repeats_rad * floor.repeats_rad;
          expected += floor.expected_rad * floor.expected_rad;
          out.assumed = false;
        }
      }
    }
    out.logs.push_back(std::move(floor));
  }
  if (expected > 0) out.factor = std::sqrt(measured / expected);
  return out;
}

}  // namespace darwinop::gap
