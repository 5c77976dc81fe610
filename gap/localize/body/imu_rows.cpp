// Gyroscope against 0 and accelerometer against gravity, while the trunk is clamped.
#include <Eigen/Cholesky>
#include <cmath>

#include "gap/localize/absorb.hpp"
#include "gap/localize/body/body_table.hpp"
#include "gap/localize/body/resting_noise.hpp"

namespace darwinop::gap {

std::vector<BodyRow> imuRows(const BodyCase& given, const RestingImu& imu) {
  constexpr std::array kAxes{"x", "y", "z"};
  std::vector<BodyRow> rows;
  for (const ImuSensor sensor : kImuSensors) {
    const std::vector<RestingReading> readings = restingReadings(given, sensor);
    if (readings.empty()) continue;
    const auto n = static_cast<Eigen::Index>(readings.size());
    const Eigen::MatrixXd all = restingCovariance(given, imu, sensor, readings);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      std::vector<Eigen::Index> known;
      for (Eigen::Index i = 0; i < n; ++i)
        if (readings[static_cast<std::size_t>(i)].isKnown(axis)) known.push_back(axis * n + i);
      if (known.empty()) continue;
      BodyRow row{.signal = std::string{name(sensor)} + "." + kAxes[static_cast<std::size_t>(axis)],
                  .place = {.kind = Place::Kind::kSensor, .name = std::string{name(sensor)}},
                  .block = Block::kSensor,
                  .unit = std::string{unitOf(sensor)}};
      Eigen::VectorXd residual(std::ssize(known));
      const Eigen::MatrixXd covariance = all(known, known);
      double square = 0, scatter = 0, greatest = 0;
      for (Eigen::Index i = 0; i < residual.size(); ++i) {
        const RestingReading& reading =
            readings[static_cast<std::size_t>(known[static_cast<std::size_t>(i)] - axis * n)];
        residual[i] = reading.mean[axis] - imu.reading(sensor, reading.up)[axis];
        square += residual[i] * residual[i];
        scatter += reading.scatter[axis] * reading.scatter[axis];
        if (i > 0 && std::abs(residual[i]) <= greatest) continue;
        greatest = std::abs(residual[i]);
        const BodyLog& log = given.logs[reading.log];
        row.file = log.file, row.t0_s = 0, row.t1_s = log.time_s.back();
      }
      const auto count = static_cast<double>(residual.size());
      row.size = std::sqrt(square / count);
      row.floors = std::sqrt(square / scatter);
      row.significance = sigmasOfChiSquared(residual.dot(covariance.ldlt().solve(residual)), count);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace darwinop::gap
