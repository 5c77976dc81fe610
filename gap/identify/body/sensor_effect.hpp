// Deviations of an inertial sensor that a resting trunk shows, and fits of a set of them in closed form.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "gap/plant/body/moving_imu.hpp"

namespace darwinop::gap {

struct SensorEffect {
  enum class Number : std::uint8_t { kBias, kScale, kRotation, kMap };
  std::string_view id, at, parameter, unit;
  ImuSensor sensor;
  Number number;
  double prior_sigma;  // of each of its three numbers; a map has none
};

/// Each has its parameter for x, y and z. A map names the true axis that is read, 1 to 3, with its sign.
std::span<const SensorEffect> sensorEffects();

/// The sensors with this effect. `values`: of x, y and z.
void applyTo(ImuDeviation& imu, const SensorEffect& effect, const std::vector<double>& values);

/// A model of one sensor with some effects, fitted.
struct SensorFit {
  std::vector<const SensorEffect*> effects;
  std::array<int, 3> map{1, 2, 3};
  std::size_t maps_alike = 1;                // maps that these orientations do not distinguish from it
  RestingImu::Deviation deviation = {};      // most probable values
  Eigen::VectorXd values = {}, sigmas = {};  // of all but the map, in the order of `effects`
  double chi2 = 0;                           // of the readings, in units of their noise and of the prior of the bias
  double evidence = 0;  // twice its logarithm; each effect pays for the names that it was chosen from

  [[nodiscard]] bool has(SensorEffect::Number number) const;
  /// Every effect of `other`, and more.
  [[nodiscard]] bool extends(const SensorFit& other) const;
};

/// The readings of one sensor in the logs with a clamped trunk that are held out, or in the others, as one vector.
class RestingProblem {
 public:
  RestingProblem(const BodyCase& given, const RestingImu& imu, ImuSensor sensor, bool held_out = false);

  /// Most probable values of the numbers of these effects. For a map, the best of the 47.
  [[nodiscard]] SensorFit fit(std::vector<const SensorEffect*> effects) const;
  /// Twice the negative log likelihood of these readings under a fit to any, up to a constant.
  [[nodiscard]] double misfitOf(const SensorFit& fit) const;
  [[nodiscard]] Eigen::Index readings() const { return measured_.size(); }

 private:
  /// A sensor with other axes shows the errors of the stand in other axes.
  struct Noise {
    Eigen::MatrixXd factor;  // of the covariance of the readings, Cholesky
    double log_determinant;  // of the covariance
  };
  [[nodiscard]] Noise noiseFor(const std::array<int, 3>& map) const;
  [[nodiscard]] Eigen::VectorXd whitened(const RestingImu::Deviation& deviation, const Noise& noise) const;
  /// With these numbers free and the others 0. Returns twice the log evidence without the price of names.
  double solve(SensorFit& fit, const std::vector<Eigen::Index>& free, const Noise& noise) const;

  const BodyCase& given_;
  const RestingImu& imu_;
  ImuSensor sensor_;
  std::vector<RestingReading> logs_;
  std::vector<Eigen::Index> known_;  // axis by axis, of all readings
  Eigen::VectorXd measured_;
  Noise straight_;  // with the model's axes
};

}  // namespace darwinop::gap
