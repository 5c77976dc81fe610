// The inertial sensor while the trunk is clamped: its rate is 0 and its acceleration is gravity, by kinematics alone.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

enum class ImuSensor : std::uint8_t { kGyro, kAccelerometer };
inline constexpr std::array kImuSensors{ImuSensor::kGyro, ImuSensor::kAccelerometer};

/// "gyro", as in the columns of a recording; its unit; the step of its register.
std::string_view name(ImuSensor sensor);
std::string_view unitOf(ImuSensor sensor);
double stepOf(ImuSensor sensor);
/// Of the bias, in BodyCase::trust.
std::string_view biasKeyOf(ImuSensor sensor);

/// Of one log with a clamped trunk, in the sensor's axes.
struct RestingReading {
  std::size_t log = 0;      // index in the case
  Eigen::Vector3d up;       // unit vector in the trunk's frame
  Eigen::Vector3d mean;     // NaN: not measured
  Eigen::Vector3d sigma;    // standard deviation of the mean
  Eigen::Vector3d scatter;  // of a single reading: noise, and the step of the register

  [[nodiscard]] bool isKnown(Eigen::Index axis) const { return !std::isnan(mean[axis]); }
};

/// Mean readings of the clamped logs that are held out, or of the others, with a reading in at least one axis.
std::vector<RestingReading> restingReadings(const BodyCase& given, ImuSensor sensor, bool held_out = false);

/// Standard deviation of one reading, for x, y and z: what clamped logs for fits show, or that of its register.
Eigen::Vector3d readingNoise(const BodyCase& given, ImuSensor sensor);

/// What a resting sensor of the model reads.
class RestingImu {
 public:
  /// Reads the body's MuJoCo file. Throws std::runtime_error.
  explicit RestingImu(const twin::Model& model);

  /// `rotation`: of the board that has the sensors, as a rotation vector in the trunk's frame. `map`: from the sensor's
  /// axes to those that are read.
  struct Deviation {
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero();
    Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
    Eigen::Vector3d scale = Eigen::Vector3d::Ones(), bias = Eigen::Vector3d::Zero();
  };
  [[nodiscard]] Eigen::Vector3d reading(ImuSensor sensor, const Eigen::Vector3d& up, const Deviation& deviation) const;
  [[nodiscard]] Eigen::Vector3d reading(ImuSensor sensor, const Eigen::Vector3d& up) const;

 private:
  Eigen::Matrix3d axes_;  // rows: the accelerometer's axes in the trunk's frame
  double gravity_m_s2_;
  twin::ImuSettings settings_;
};

}  // namespace darwinop::gap
