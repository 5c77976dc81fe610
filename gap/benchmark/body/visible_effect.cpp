#include "gap/benchmark/body/visible_effect.hpp"

#include <algorithm>
#include <cmath>

#include "gap/plant/registers.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kHalfASecond = 31;  // rows of 16 ms

/// Squares of the difference of each row; 0 where one is not known.
std::vector<double> squares(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> out(a.size());
  for (std::size_t row = 0; row < out.size(); ++row) {
    const double difference = a[row] - b[row];
    out[row] = std::isfinite(difference) ? difference * difference : 0;
  }
  return out;
}

/// `least`: of the noise.
double worstOf(const std::vector<double>& with, const std::vector<double>& without, const std::vector<double>& again,
               double least) {
  const std::vector<double> effect = squares(with, without), noise = squares(with, again);
  double variance = 0, sum = 0, worst = 0;
  for (const double one : noise) variance += one / 2 / static_cast<double>(noise.size());
  for (std::size_t row = 0; row < effect.size(); ++row) {
    sum += effect[row];
    if (row >= kHalfASecond) sum -= effect[row - kHalfASecond];
    worst = std::max(worst, sum);
  }
  return std::sqrt(worst / kHalfASecond / std::max(variance, least * least));
}

}  // namespace

double worstDifference(const BodyCase& with, const BodyCase& without, const BodyCase& again,
                       const std::vector<std::size_t>& logs) {
  const double of_reading = readingSigma(with.joints.model.servo);
  double worst = 0;
  const auto take = [&](double one) { worst = std::max(worst, one); };
  for (const std::size_t log : logs) {
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      take(worstOf(with.joint(log, joint).position_rad, without.joint(log, joint).position_rad,
                   again.joint(log, joint).position_rad, of_reading));
    // Every reading of the sensor has noise of its own.
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto of = [&](const AxesColumns BodyLog::*sensor) {
        return worstOf((with.logs[log].*sensor)[axis], (without.logs[log].*sensor)[axis],
                       (again.logs[log].*sensor)[axis], 0);
      };
      take(of(&BodyLog::gyro_rad_s)), take(of(&BodyLog::accel_m_s2));
    }
  }
  return worst;
}

}  // namespace darwinop::gap
