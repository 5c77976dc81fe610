#include "gap/plan/body/predicted_signals.hpp"

#include <algorithm>
#include <cmath>

#include "core/registers.hpp"
#include "core/servo_limits.hpp"
#include "gap/plant/registers.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr int kNoiseRepeats = 4;
constexpr Eigen::Index kHalfSecond = 15;  // rows on either side over which the variance of repeats is averaged

std::vector<PredictedSignal> clampedSignals(const BodyCase& coming, std::size_t log, const FloorModel& model,
                                            const Disturbance* noise) {
  std::vector<PredictedSignal> out;
  for (const Limb& limb : limbsOf(coming.joints.model)) {
    const LimbTrace trace = rollOut(coming, log, limb, model.robot.robot, noise);
    for (std::size_t k = 0; k < limb.size(); ++k) {
      const std::string joint{row(limb[k].joint).name};
      const auto column = static_cast<Eigen::Index>(k);
      out.push_back({.name = joint + ".position", .values = trace.position_rad.col(column)});
      out.push_back({.name = joint + ".load", .values = trace.duty.col(column)});
    }
  }
  return out;
}

std::vector<PredictedSignal> freeSignals(const BodyCase& coming, std::size_t log, const FloorModel& model,
                                         const Disturbance* noise) {
  const FloorTrace trace = rollOut(coming, log, model.robot, noise);
  const MovingImu::Readings imu = MovingImu{coming.joints.model}.of(trace, model.imu);
  std::vector<PredictedSignal> out;
  Eigen::MatrixXd all(trace.position_rad.rows(), kFloorSignals);
  all << trace.position_rad, imu.gyro_rad_s, imu.accel_m_s2;
  for (std::size_t signal = 0; signal < kFloorSignals; ++signal)
    out.push_back({.name = floorSignal(signal), .values = all.col(static_cast<Eigen::Index>(signal))});
  return out;
}

/// Of one reading, without what differs between repeats.
double readingSigma(const BodyCase& coming, const std::string& signal) {
  if (signal.ends_with(".position")) return kRoundingSigma * kRadPerTick;
  if (signal.ends_with(".load")) return std::max(find(kMx28, "present_load").scale, thresholds::kLawResidual);
  const ImuSensor sensor = signal.starts_with("gyro") ? ImuSensor::kGyro : ImuSensor::kAccelerometer;
  return readingNoise(coming, sensor)[signal.back() - 'x'];
}

void setNoise(const BodyCase& coming, std::vector<PredictedSignal>& of,
              const std::vector<std::vector<PredictedSignal>>& repeats) {
  for (std::size_t i = 0; i < of.size(); ++i) {
    const Eigen::Index n = of[i].values.size();
    Eigen::VectorXd variance = Eigen::VectorXd::Zero(n);
    for (const auto& repeat : repeats)
      variance += (repeat[i].values - of[i].values).cwiseAbs2() / static_cast<double>(repeats.size());
    variance = variance.unaryExpr([](double value) { return std::isfinite(value) ? value : 0.0; });
    const double own = std::pow(readingSigma(coming, of[i].name), 2);
    of[i].sigma.resize(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const Eigen::Index from = std::max<Eigen::Index>(0, k - kHalfSecond), to = std::min(n - 1, k + kHalfSecond);
      of[i].sigma[k] = std::sqrt(own + variance.segment(from, to - from + 1).mean());
    }
    of[i].rows_alike = thresholds::kCorrelatedSamples;
  }
}

void addResting(const BodyCase& coming, std::size_t log, const FloorModel& model, std::vector<PredictedSignal>& into) {
  const BodyLog& of = coming.logs[log];
  const RestingImu imu{coming.joints.model};
  const Eigen::Vector3d up{(*of.up)[0], (*of.up)[1], (*of.up)[2]};
  for (const ImuSensor sensor : kImuSensors) {
    const Eigen::Vector3d mean = imu.reading(sensor, up, sensor == ImuSensor::kGyro ? model.imu.gyro : model.imu.accel),
                          noise = readingNoise(coming, sensor);
    // Samples in a row are alike, and a prior allows a bias.
    const double samples = std::max(1.0, static_cast<double>(of.rows()) / thresholds::kCorrelatedSamples),
                 bias = coming.sigmaOf(biasKeyOf(sensor));
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      into.push_back({.name = std::string{name(sensor)} + "." + static_cast<char>('x' + axis),
                      .values = Eigen::VectorXd::Constant(1, mean[axis]),
                      .sigma = Eigen::VectorXd::Constant(1, std::hypot(noise[axis] / std::sqrt(samples), bias))});
  }
}

}  // namespace

std::vector<PredictedSignal> predictedSignals(const BodyCase& coming, std::size_t log, const FloorModel& model,
                                              bool with_noise) {
  const bool is_clamped = coming.logs[log].setup == BodySetup::kClamped;
  const auto simulated = [&](const Disturbance* noise) {
    return is_clamped ? clampedSignals(coming, log, model, noise) : freeSignals(coming, log, model, noise);
  };
  std::vector<PredictedSignal> out = simulated(nullptr);
  if (with_noise) {
    std::vector<std::vector<PredictedSignal>> repeats;
    for (int run = 0; run < kNoiseRepeats; ++run) {
      const Disturbance noise{.seed = static_cast<std::uint64_t>(run + 1)};
      repeats.push_back(simulated(&noise));
    }
    setNoise(coming, out, repeats);
  }
  if (is_clamped) addResting(coming, log, model, out);
  return out;
}

SignalDifference differenceOf(const std::vector<PredictedSignal>& a, const std::vector<PredictedSignal>& b) {
  SignalDifference out;
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    double square = 0, noise = 0, significance = 0;
    for (Eigen::Index k = 0; k < a[i].values.size(); ++k) {
      const double difference = b[i].values[k] - a[i].values[k], sigma = a[i].sigma[k];
      if (!std::isfinite(difference)) continue;
      square += difference * difference, noise += sigma * sigma;
      significance += std::pow(difference / sigma, 2) / a[i].rows_alike;
    }
    sum += significance;
    const double floors = noise > 0 ? std::sqrt(square / noise) : 0;
    if (floors > out.floors) out.floors = floors, out.largest = a[i].name;
  }
  out.sigma = std::sqrt(sum);
  return out;
}

}  // namespace darwinop::gap
