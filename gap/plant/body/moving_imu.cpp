#include "gap/plant/body/moving_imu.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "twin/body/imu_axes.hpp"
#include "twin/body/sensor_lag.hpp"

namespace darwinop::gap {
namespace {

Eigen::Map<const Eigen::Vector3d> ofAxes(const std::array<double, 3>& values) {
  return Eigen::Map<const Eigen::Vector3d>{values.data()};
}

Eigen::Matrix3d matrixOf(const twin::MountingMatrix& rows) {
  Eigen::Matrix3d out;
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index k = 0; k < 3; ++k) out(i, k) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  return out;
}

/// Of a trace's signal, without bias.
Eigen::Matrix3d distortion(const std::array<double, 3>& scale, const RestingImu::Deviation& of,
                           const Eigen::Vector3d& board, const Eigen::Matrix3d& axes) {
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  if (const double angle = board.norm(); angle > 0)
    turned = Eigen::AngleAxisd{-angle, board / angle}.toRotationMatrix();
  return ofAxes(scale).cwiseProduct(of.scale).asDiagonal() * of.map * axes * turned * axes.transpose();
}

void addBias(Eigen::MatrixX3d& readings, const Eigen::Vector3d& bias, double range) {
  readings.rowwise() += bias.transpose();
  readings = readings.cwiseMin(range).cwiseMax(-range);
}

/// Rows of `cycles` at the time of each row of the log, `late` cycles ago.
Eigen::MatrixX3d atRows(const Eigen::MatrixX3d& cycles, const std::vector<Eigen::Index>& rows, double late) {
  Eigen::MatrixX3d out(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double at = std::clamp(static_cast<double>(rows[row]) - late, 0.0, static_cast<double>(cycles.rows() - 1));
    const auto before = static_cast<Eigen::Index>(at);
    const double share = at - static_cast<double>(before);
    out.row(static_cast<Eigen::Index>(row)) = cycles.row(before);
    if (share > 0) out.row(static_cast<Eigen::Index>(row)) += share * (cycles.row(before + 1) - cycles.row(before));
  }
  return out;
}

}  // namespace

twin::ImuSettings tracedSensors(twin::ImuSettings model) {
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  model.gyro_scale = model.accel_scale = {1, 1, 1};
  model.gyro_bias_rad_s = model.accel_bias_m_s2 = {0, 0, 0};
  model.gyro_noise_rad_s = model.accel_noise_m_s2 = 0;
  model.gyro_range_rad_s = model.accel_range_m_s2 = kNoLimit;
  return model;
}

MovingImu::MovingImu(const twin::Model& model) : settings_{model.imu}, period_s_{model.servo.firmware_period_s} {
  const twin::ImuAxes mounted = twin::imuAxesOf(model);
  gyro_axes_ = matrixOf(mounted.gyro), accel_axes_ = matrixOf(mounted.accelerometer);
}

Eigen::Matrix3d MovingImu::gyroMatrix(const ImuDeviation& deviation) const {
  return distortion(settings_.gyro_scale, deviation.gyro, deviation.accel.rotation, gyro_axes_);
}

MovingImu::Readings MovingImu::of(const FloorTrace& trace, const ImuDeviation& deviation) const {
  const double late = deviation.delay_s / period_s_;
  Eigen::MatrixX3d slow;
  const Eigen::MatrixX3d* rates = &trace.gyro_rad_s;
  if (deviation.lowpass_s > 0) {
    slow = trace.gyro_rad_s;
    const double share = twin::lowpassShare(period_s_, deviation.lowpass_s);
    for (Eigen::Index i = 1; i < slow.rows(); ++i)
      slow.row(i) = slow.row(i - 1) + share * (slow.row(i) - slow.row(i - 1));
    rates = &slow;
  }
  Readings out{atRows(*rates, trace.cycle_of_row, late), atRows(trace.accel_m_s2, trace.cycle_of_row, late)};
  out.gyro_rad_s *= gyroMatrix(deviation).transpose();
  addBias(out.gyro_rad_s, ofAxes(settings_.gyro_bias_rad_s) + deviation.gyro.bias,
          std::min(settings_.gyro_range_rad_s, deviation.range_rad_s));
  out.accel_m_s2 *=
      distortion(settings_.accel_scale, deviation.accel, deviation.accel.rotation, accel_axes_).transpose();
  addBias(out.accel_m_s2, ofAxes(settings_.accel_bias_m_s2) + deviation.accel.bias, settings_.accel_range_m_s2);
  return out;
}

}  // namespace darwinop::gap
