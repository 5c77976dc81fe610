#include "gap/localize/body/resting_noise.hpp"

namespace darwinop::gap {
namespace {

/// Logs that repeat one another were made without moving the stand.
std::size_t placementOf(const BodyCase& given, std::size_t log) {
  for (std::size_t steps = 0; steps < given.logs.size() && given.logs[log].repeat_of; ++steps)
    log = *given.logs[log].repeat_of;
  return log;
}

/// Reading by direction of up, which is linear. A scale or rotation that is sought changes it by some percent, and
/// what a stand is off by is known less well.
Eigen::Matrix3d slopeOf(const RestingImu& imu, ImuSensor sensor, const Eigen::Matrix3d& map) {
  RestingImu::Deviation mapped;
  mapped.map = map;
  Eigen::Matrix3d slope;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    slope.col(axis) =
        imu.reading(sensor, Eigen::Vector3d::Unit(axis), mapped) - imu.reading(sensor, Eigen::Vector3d::Zero(), mapped);
  return slope;
}

}  // namespace

Eigen::MatrixXd restingCovariance(const BodyCase& given, const RestingImu& imu, ImuSensor sensor,
                                  const std::vector<RestingReading>& readings, const Eigen::Matrix3d& map) {
  const auto n = static_cast<Eigen::Index>(readings.size());
  const double bias_sigma = given.sigmaOf(biasKeyOf(sensor)), up_sigma = given.sigmaOf(kUpSigma);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Index at = axis * n;
    out.block(at, at, n, n).setConstant(bias_sigma * bias_sigma);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double sigma = readings[static_cast<std::size_t>(i)].sigma[axis];
      out(at + i, at + i) += sigma * sigma;
    }
  }
  if (up_sigma == 0) return out;
  const Eigen::Matrix3d slope = slopeOf(imu, sensor, map);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const RestingReading &a = readings[static_cast<std::size_t>(i)], &b = readings[static_cast<std::size_t>(j)];
      if (placementOf(given, a.log) != placementOf(given, b.log) || a.up != b.up) continue;
      const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - a.up * a.up.transpose();  // no tilt along `up`
      const Eigen::Matrix3d tilt = up_sigma * up_sigma * slope * across * slope.transpose();
      for (Eigen::Index row = 0; row < 3; ++row)
        for (Eigen::Index column = 0; column < 3; ++column) out(row * n + i, column * n + j) += tilt(row, column);
    }
  return out;
}

}  // namespace darwinop::gap
