#include "gap/identify/body/floor_errors.hpp"

#include <cmath>

namespace darwinop::gap {

FloorErrors heldOutFloor(const BodyCase& given, const MovingImu& imu, const FloorModel& model) {
  double squares[3] = {}, counts[3] = {};
  const std::vector<std::size_t> logs = floorLogs(given, true);
  const FloorTraces traces = simulateFloor(given, logs, {model.robot}).front();
  const auto add = [&](int kind, const std::vector<double>& measured, const Eigen::VectorXd& expected) {
    for (std::size_t row = 0; row < measured.size(); ++row) {
      const double error = measured[row] - expected[static_cast<Eigen::Index>(row)];
      if (!std::isnan(error)) squares[kind] += error * error, counts[kind] += 1;
    }
  };
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const MovingImu::Readings sensed = imu.of(traces[i], model.imu);
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      add(0, given.joint(logs[i], joint).position_rad, traces[i].position_rad.col(static_cast<Eigen::Index>(joint)));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto column = static_cast<Eigen::Index>(axis);
      add(1, given.logs[logs[i]].gyro_rad_s[axis], sensed.gyro_rad_s.col(column));
      add(2, given.logs[logs[i]].accel_m_s2[axis], sensed.accel_m_s2.col(column));
    }
  }
  return {std::sqrt(squares[0] / counts[0]), std::sqrt(squares[1] / counts[1]), std::sqrt(squares[2] / counts[2])};
}

}  // namespace darwinop::gap
