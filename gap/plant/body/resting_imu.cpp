#include "gap/plant/body/resting_imu.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/registers.hpp"
#include "gap/plant/registers.hpp"
#include "gap/thresholds.hpp"
#include "twin/body/imu_axes.hpp"

namespace darwinop::gap {
namespace {

constexpr Register kGyro = find(kCm730, "gyro_x"), kAccelerometer = find(kCm730, "accel_x");  // all axes have its scale

struct ColumnMean {
  double mean, sigma, scatter;
};

/// Samples that count as one, by the autocorrelation over some rows (Bartlett's weights): vibration is not white.
double correlatedSamples(const std::vector<double>& known, double mean, double variance) {
  constexpr auto kLags = static_cast<std::size_t>(thresholds::kCorrelatedSamples);
  if (known.size() <= kLags || !(variance > 0)) return 1;
  double sum = 1;
  for (std::size_t lag = 1; lag < kLags; ++lag) {
    double product = 0;
    for (std::size_t i = lag; i < known.size(); ++i) product += (known[i] - mean) * (known[i - lag] - mean);
    const double weight = 1 - static_cast<double>(lag) / static_cast<double>(kLags);
    sum += 2 * weight * product / (variance * static_cast<double>(known.size()));
  }
  return std::max(1.0, sum);
}

ColumnMean meanOf(const std::vector<double>& column, double step) {
  std::vector<double> known;
  std::ranges::copy_if(column, std::back_inserter(known), [](double value) { return !std::isnan(value); });
  const auto count = static_cast<double>(known.size());
  if (count < 2) return {std::numeric_limits<double>::quiet_NaN(), 0, 0};
  double mean = 0, variance = 0;
  for (const double value : known) mean += value / count;
  for (const double value : known) variance += (value - mean) * (value - mean) / (count - 1);
  const double rounding = step * kRoundingSigma, scatter = std::max(std::sqrt(variance), rounding);
  double sigma = scatter * std::sqrt(correlatedSamples(known, mean, variance) / count);
  // With noise far below a step every reading is rounded alike, and the mean is no finer than a reading.
  if (std::sqrt(variance) < step / 4) sigma = std::hypot(sigma, rounding);
  return {mean, sigma, scatter};
}

Eigen::Vector3d vectorOf(const std::array<double, 3>& values) {
  return {values[0], values[1], values[2]};
}

}  // namespace

std::string_view name(ImuSensor sensor) {
  return sensor == ImuSensor::kGyro ? "gyro" : "accelerometer";
}

std::string_view unitOf(ImuSensor sensor) {
  return sensor == ImuSensor::kGyro ? kGyro.unit : kAccelerometer.unit;
}

double stepOf(ImuSensor sensor) {
  return sensor == ImuSensor::kGyro ? kGyro.scale : kAccelerometer.scale;
}

std::string_view biasKeyOf(ImuSensor sensor) {
  return sensor == ImuSensor::kGyro ? "imu.gyro_bias_rad_s" : "imu.accel_bias_m_s2";
}

std::vector<RestingReading> restingReadings(const BodyCase& given, ImuSensor sensor, bool held_out) {
  std::vector<RestingReading> out;
  for (std::size_t i = 0; i < given.logs.size(); ++i) {
    const BodyLog& log = given.logs[i];
    if (!log.up || log.held_out != held_out) continue;
    const AxesColumns& columns = sensor == ImuSensor::kGyro ? log.gyro_rad_s : log.accel_m_s2;
    RestingReading reading{.log = i, .up = vectorOf(*log.up), .mean = {}, .sigma = {}, .scatter = {}};
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const ColumnMean mean = meanOf(columns[static_cast<std::size_t>(axis)], stepOf(sensor));
      reading.mean[axis] = mean.mean, reading.sigma[axis] = mean.sigma, reading.scatter[axis] = mean.scatter;
    }
    if (!reading.mean.array().isNaN().all()) out.push_back(reading);
  }
  return out;
}

Eigen::Vector3d readingNoise(const BodyCase& given, ImuSensor sensor) {
  Eigen::Vector3d out = Eigen::Vector3d::Constant(stepOf(sensor) * std::hypot(0.5, kRoundingSigma));
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<RestingReading> readings = restingReadings(given, sensor);
    std::erase_if(readings, [&](const RestingReading& one) { return !one.isKnown(axis); });
    double square = 0;
    for (const RestingReading& one : readings)
      square += one.scatter[axis] * one.scatter[axis] / static_cast<double>(readings.size());
    if (!readings.empty()) out[axis] = std::sqrt(square);
  }
  return out;
}

RestingImu::RestingImu(const twin::Model& model) : settings_{model.imu} {
  const twin::ImuAxes mounted = twin::imuAxesOf(model);
  gravity_m_s2_ = mounted.gravity_m_s2;
  for (Eigen::Index i = 0; i < 3; ++i) axes_.row(i) = vectorOf(mounted.accelerometer[static_cast<std::size_t>(i)]);
}

Eigen::Vector3d RestingImu::reading(ImuSensor sensor, const Eigen::Vector3d& up, const Deviation& deviation) const {
  const bool is_gyro = sensor == ImuSensor::kGyro;
  const Eigen::Vector3d known_bias = vectorOf(is_gyro ? settings_.gyro_bias_rad_s : settings_.accel_bias_m_s2);
  if (is_gyro) return known_bias + deviation.bias;
  const double angle = deviation.rotation.norm();
  Eigen::Vector3d on_board = up * gravity_m_s2_;
  if (angle > 0) on_board = Eigen::AngleAxisd{-angle, deviation.rotation / angle} * on_board;
  const Eigen::Vector3d scale = vectorOf(settings_.accel_scale).cwiseProduct(deviation.scale);
  return scale.cwiseProduct(deviation.map * (axes_ * on_board)) + known_bias + deviation.bias;
}

Eigen::Vector3d RestingImu::reading(ImuSensor sensor, const Eigen::Vector3d& up) const {
  return reading(sensor, up, Deviation{});
}

}  // namespace darwinop::gap
