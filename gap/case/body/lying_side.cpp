#include "gap/case/body/lying_side.hpp"

#include <cmath>

namespace darwinop::gap {
namespace {

constexpr double kFirstRows = 0.5;     // s
constexpr double kLeastOfGravity = 5;  // m/s2, about half of it
constexpr long kRight = 1;             // the sensor's first true axis, as ImuSettings::accel_axes counts

double meanOfFirst(const std::vector<double>& time_s, const std::vector<double>& values) {
  double sum = 0, count = 0;
  for (std::size_t row = 0; row < values.size() && time_s[row] <= kFirstRows; ++row)
    if (!std::isnan(values[row])) sum += values[row], ++count;
  return sum / count;  // NaN: not measured
}

}  // namespace

std::string_view sideOf(const BodyLog& log, const twin::ImuSettings& imu) {
  for (std::size_t axis = 0; axis < log.accel_m_s2.size(); ++axis) {
    if (std::lround(std::abs(imu.accel_axes[axis])) != kRight) continue;
    const double read = meanOfFirst(log.time_s, log.accel_m_s2[axis]) - imu.accel_bias_m_s2[axis];
    const double right = read / imu.accel_scale[axis] * (imu.accel_axes[axis] < 0 ? -1 : 1);
    if (right > kLeastOfGravity) return "left";  // what is up is read as positive
    if (right < -kLeastOfGravity) return "right";
  }
  return {};
}

}  // namespace darwinop::gap
