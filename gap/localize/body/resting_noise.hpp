// By how much the mean readings of a clamped trunk's sensor may differ from the model's while nothing is missing in it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gap/plant/body/resting_imu.hpp"

namespace darwinop::gap {

/// Covariance of these readings, axis by axis: entry `axis * readings.size() + i`. The noise of each mean, one bias for
/// all logs within its prior, and the directions of the stand within theirs, seen through a sensor whose axes are
/// mapped like this. An unknown mean has an entry without meaning.
Eigen::MatrixXd restingCovariance(const BodyCase& given, const RestingImu& imu, ImuSensor sensor,
                                  const std::vector<RestingReading>& readings,
                                  const Eigen::Matrix3d& map = Eigen::Matrix3d::Identity());

}  // namespace darwinop::gap
