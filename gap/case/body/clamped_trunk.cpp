#include "gap/case/body/clamped_trunk.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "gap/case/median.hpp"

namespace darwinop::gap {
namespace {

std::vector<double> knownOf(const std::vector<double>& values) {
  std::vector<double> known;
  std::ranges::copy_if(values, std::back_inserter(known), [](double value) { return !std::isnan(value); });
  return known;
}

}  // namespace

double greatestRate(const AxesColumns& gyro) {
  double greatest = 0;
  for (const std::vector<double>& axis : gyro) {
    const std::vector<double> known = knownOf(axis);
    const double median = medianOf(known);
    for (const double value : known) greatest = std::max(greatest, std::abs(value - median));
  }
  return greatest;
}

double greatestTurn(const BodyLog& log) {
  double greatest = 0;
  for (const std::vector<double>& axis : log.gyro_rad_s) {
    double sum = 0, count = 0;
    for (const double value : knownOf(axis)) sum += value, count += 1;
    double angle = 0, low = 0, high = 0;
    for (std::size_t row = 1; row < log.rows(); ++row) {
      if (std::isnan(axis[row])) continue;
      angle += (axis[row] - sum / count) * (log.time_s[row] - log.time_s[row - 1]);
      low = std::min(low, angle), high = std::max(high, angle);
    }
    greatest = std::max(greatest, high - low);
  }
  return greatest;
}

}  // namespace darwinop::gap
