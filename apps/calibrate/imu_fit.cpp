#include "apps/calibrate/imu_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/calibrate/least_squares.hpp"

namespace darwinop::calibrate {
namespace {

using cm730::ImuCalibration;
using cm730::ImuCorrection;

// Priors, standard deviations. The data sheet of the board's accelerometer (LIS344ALH) gives a zero level within 5 % of
// the supply, which is 0.75 g over temperature and life, and a sensitivity within 5 %; a board sits within some
// degrees.
constexpr double kBiasPrior = 1.0;  // m/s2
constexpr double kScalePrior = 0.05;
constexpr double kMountingPrior = 0.1;  // rad, 6 deg

constexpr std::size_t kMounting = 0, kBias = 3, kScale = 6, kUnknowns = 9;
constexpr std::size_t kFewestToLeaveOneOut = 4;

ImuCalibration accelerometerOf(const std::vector<double>& x) {
  ImuCalibration out;
  for (std::size_t i = 0; i < 3; ++i) {
    out.mounting_rad[i] = x[kMounting + i];
    out.accel_bias_m_s2[i] = x[kBias + i];
    out.accel_scale[i] = 1 + x[kScale + i];
  }
  return out;
}

/// Differences of reading and model, whitened. The levelling error tilts gravity: it acts across it, never along it.
void appendResiduals(const PostureReading& reading, const ImuCorrection& model, double level_rad,
                     std::vector<double>& out) {
  const Axes gravity = reading.posture->gravity();
  const Axes expected = model.rawAccelerometer(gravity);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_across = gravity[i] == 0;  // each posture has one axis upright
    const double sigma = std::hypot(reading.raw.accel_sigma[i], is_across ? level_rad * kGravity : 0);
    out.push_back((reading.raw.accel[i] - expected[i]) / sigma);
  }
}

LeastSquares fitAccelerometer(const std::vector<PostureReading>& readings, double level_deg) {
  const auto residuals = [&](const std::vector<double>& x) {
    const ImuCorrection model{accelerometerOf(x)};
    std::vector<double> out;
    for (const PostureReading& reading : readings) appendResiduals(reading, model, level_deg * kRadPerDegree, out);
    for (std::size_t i = 0; i < 3; ++i) {
      out.push_back(x[kMounting + i] / kMountingPrior);
      out.push_back(x[kBias + i] / kBiasPrior);
      out.push_back(x[kScale + i] / kScalePrior);
    }
    return out;
  };
  return leastSquares(residuals, std::vector<double>(kUnknowns), std::vector<double>(kUnknowns, 1e-5));
}

/// A number is observed if the readings know it better than the prior does.
bool allObserved(const LeastSquares& fit) {
  constexpr double kShareOfPrior = 0.5;
  for (std::size_t i = 0; i < kUnknowns; ++i) {
    const double prior = i < kBias ? kMountingPrior : i < kScale ? kBiasPrior : kScalePrior;
    if (fit.sigmas[i] > kShareOfPrior * prior) return false;
  }
  return true;
}

/// A resting gyroscope reads its bias in every posture. Postures count alike: the bias drifts more between them than
/// within one.
void takeGyro(const std::vector<PostureReading>& readings, ImuFit& out) {
  const auto count = static_cast<double>(readings.size());
  for (std::size_t i = 0; i < 3; ++i) {
    double mean = 0, between = 0, within = 0;
    for (const PostureReading& reading : readings) mean += reading.raw.gyro[i] / count;
    for (const PostureReading& reading : readings) {
      between += (reading.raw.gyro[i] - mean) * (reading.raw.gyro[i] - mean) / std::max(1.0, count - 1);
      within = std::max(within, reading.raw.gyro_sigma[i]);  // rounding is common to all postures
    }
    out.calibration.gyro_bias_rad_s[i] = mean;
    out.sigma.gyro_bias_rad_s[i] = std::hypot(within, std::sqrt(between / count));
  }
}

double predictedErrorDeg(const std::vector<PostureReading>& readings, std::size_t left_out, double level_deg) {
  if (readings.size() < kFewestToLeaveOneOut) return std::numeric_limits<double>::quiet_NaN();
  std::vector<PostureReading> others = readings;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
  return tiltErrorDeg(readings[left_out], accelerometerOf(fitAccelerometer(others, level_deg).values));
}

}  // namespace

double tiltErrorDeg(const PostureReading& reading, const ImuCalibration& calibration) {
  const Axes measured = ImuCorrection{calibration}.accelerometer(reading.raw.accel), up = reading.posture->gravity();
  double dot = 0;
  for (std::size_t i = 0; i < 3; ++i) dot += measured[i] * up[i];
  const double lengths = std::hypot(measured[0], measured[1], measured[2]) * kGravity;
  return std::acos(std::clamp(dot / lengths, -1.0, 1.0)) / kRadPerDegree;
}

ImuFit fitImu(const std::vector<PostureReading>& readings, double level_deg, const ImuCalibration& before) {
  const LeastSquares fit = fitAccelerometer(readings, level_deg);
  ImuFit out{.calibration = accelerometerOf(fit.values), .sigma = accelerometerOf(fit.sigmas), .errors = {}};
  for (double& sigma : out.sigma.accel_scale) sigma -= 1;
  out.observed = allObserved(fit);
  takeGyro(readings, out);
  for (std::size_t i = 0; i < readings.size(); ++i)
    out.errors.push_back({readings[i].posture, tiltErrorDeg(readings[i], before),
                          tiltErrorDeg(readings[i], out.calibration), predictedErrorDeg(readings, i, level_deg)});
  return out;
}

}  // namespace darwinop::calibrate
