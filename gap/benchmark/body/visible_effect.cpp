#include "gap/benchmark/body/visible_effect.hpp"

#include <algorithm>
#include <cmath>

#include "gap/plant/registers.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kHalfASecond = 31;  // rows of 16 ms

/// Squared difference of each row; NaN where a reading is missing.
std::vector<double> squaredDifferences(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> out(a.size());
  std::ranges::transform(a, b, out.begin(), [](double x, double y) { return (x - y) * (x - y); });
  return out;
}

/// Half the mean squared difference of two repeats; NaN without a reading that both have.
double noiseVariance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0, count = 0;
  for (const double square : squaredDifferences(a, b))
    if (!std::isnan(square)) sum += square, ++count;
  return sum / count / 2;
}

/// In standard deviations of the noise, which is at least `least_sigma`.
double largestDifference(const std::vector<double>& with, const std::vector<double>& without,
                         const std::vector<double>& again, double least_sigma) {
  const double variance = noiseVariance(with, again);
  if (std::isnan(variance)) return 0;
  std::vector<double> effect = squaredDifferences(with, without);
  std::ranges::replace_if(
      effect, [](double square) { return std::isnan(square); }, 0.0);
  double sum = 0, largest = 0;
  for (std::size_t row = 0; row < effect.size(); ++row) {
    sum += effect[row];
    if (row >= kHalfASecond) sum -= effect[row - kHalfASecond];
    largest = std::max(largest, sum);
  }
  return std::sqrt(largest / kHalfASecond / std::max(variance, least_sigma * least_sigma));
}

}  // namespace

double worstDifference(const BodyCase& with, const BodyCase& without, const BodyCase& again,
                       const std::vector<std::size_t>& logs) {
  const double reading_sigma = readingSigma(with.joints.model.servo);
  double worst = 0;
  const auto include = [&](double difference) { worst = std::max(worst, difference); };
  for (const std::size_t log : logs) {
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      include(largestDifference(with.joint(log, joint).position_rad, without.joint(log, joint).position_rad,
                                again.joint(log, joint).position_rad, reading_sigma));
    // No lower bound: the noise of the sensor exceeds its resolution.
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const auto sensor : {&BodyLog::gyro_rad_s, &BodyLog::accel_m_s2})
        include(largestDifference((with.logs[log].*sensor)[axis], (without.logs[log].*sensor)[axis],
                                  (again.logs[log].*sensor)[axis], 0));
  }
  return worst;
}

}  // namespace darwinop::gap
