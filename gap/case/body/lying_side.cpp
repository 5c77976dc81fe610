#include "gap/case/body/lying_side.hpp"

#include <cmath>
#include <numeric>

namespace darwinop::gap {
namespace {

constexpr double kFirstRows = 0.5;     // s
constexpr double kLeastOfGravity = 5;  // m/s2, about half of it
constexpr double kOnASide = 0.7;       // part of `up` that is along the trunk's left axis: nearer to it than to another
constexpr long kRight = 1;             // the sensor's first true axis, as ImuSettings::accel_axes counts

/// NaN along an axis that was not read.
Axes meanOfFirst(const BodyLog& log) {
  Axes mean{};
  for (std::size_t axis = 0; axis < mean.size(); ++axis) {
    double sum = 0, count = 0;
    for (std::size_t row = 0; row < log.rows() && log.time_s[row] <= kFirstRows; ++row)
      if (const double value = log.accel_m_s2[axis][row]; !std::isnan(value)) sum += value, ++count;
    mean[axis] = sum / count;
  }
  return mean;
}

std::string_view sideThatIsDown(double left_up_m_s2) {
  return left_up_m_s2 > kLeastOfGravity ? "right" : left_up_m_s2 < -kLeastOfGravity ? "left" : std::string_view{};
}

/// What is up is read as positive.
std::string_view byTheModel(const Axes& read, const twin::ImuSettings& imu) {
  for (std::size_t axis = 0; axis < read.size(); ++axis)
    if (std::lround(std::abs(imu.accel_axes[axis])) == kRight)
      return sideThatIsDown((imu.accel_axes[axis] < 0 ? 1 : -1) * (read[axis] - imu.accel_bias_m_s2[axis]) /
                            imu.accel_scale[axis]);
  return {};
}

}  // namespace

std::string_view sideOf(const BodyCase& given, std::size_t log) {
  const Axes read = meanOfFirst(given.logs[log]);
  for (const BodyLog& clamped : given.logs) {
    if (!clamped.up || std::abs((*clamped.up)[0]) < kOnASide) continue;
    const Axes there = meanOfFirst(clamped);
    const double length = std::hypot(there[0], there[1], there[2]);
    const double along = std::inner_product(read.begin(), read.end(), there.begin(), 0.0) / length;
    if (const auto side = sideThatIsDown(std::copysign(along, along * (*clamped.up)[0])); !side.empty()) return side;
  }
  return byTheModel(read, given.joints.model.imu);
}

}  // namespace darwinop::gap
