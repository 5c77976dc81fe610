// Most probable numbers of a set of sensor effects, and its evidence by Laplace's approximation, which is exact for
// bias and scale.
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "gap/identify/body/sensor_effect.hpp"
#include "gap/localize/body/resting_noise.hpp"

namespace darwinop::gap {
namespace {

constexpr int kIterations = 12;         // of Gauss and Newton: a rotation of 0.3 rad takes five
constexpr double kConverged = 1e-9;     // step, prior sigmas
constexpr double kDifference = 1e-4;    // of a prior sigma
constexpr double kSameEvidence = 1e-6;  // of maps that differ in axes along which gravity never was

/// The 47 signed permutations of three axes that change something.
std::vector<std::array<int, 3>> axisMaps() {
  std::vector<std::array<int, 3>> maps;
  std::array<int, 3> axes{1, 2, 3};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      std::array<int, 3> map = axes;
      for (std::size_t i = 0; i < 3; ++i)
        if ((signs >> i & 1U) != 0) map[i] = -map[i];
      if (map != std::array{1, 2, 3}) maps.push_back(map);
    }
  } while (std::ranges::next_permutation(axes).found);
  return maps;
}

Eigen::Matrix3d matrixOf(const std::array<int, 3>& map) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < 3; ++i) matrix(static_cast<Eigen::Index>(i), std::abs(map[i]) - 1) = map[i] > 0 ? 1 : -1;
  return matrix;
}

bool isMap(const SensorEffect* effect) {
  return effect->number == SensorEffect::Number::kMap;
}

/// `x`: three numbers for each effect but a map, in prior sigmas.
RestingImu::Deviation deviationOf(const SensorFit& fit, const Eigen::VectorXd& x) {
  RestingImu::Deviation out;
  out.map = matrixOf(fit.map);
  Eigen::Index at = 0;
  for (const SensorEffect* const effect : fit.effects) {
    if (isMap(effect)) continue;
    const Eigen::Vector3d values = effect->prior_sigma * x.segment<3>(at);
    at += 3;
    if (effect->number == SensorEffect::Number::kBias) out.bias = values;
    if (effect->number == SensorEffect::Number::kScale) out.scale += values;
    if (effect->number == SensorEffect::Number::kRotation) out.rotation = values;
  }
  return out;
}

/// Indices of the numbers that are free: of every effect one, two or all three. Three numbers for each of `effects`.
std::vector<std::vector<Eigen::Index>> freeNumbers(Eigen::Index effects) {
  std::vector<std::vector<Eigen::Index>> sets{{}};
  for (Eigen::Index effect = 0; effect < effects; ++effect) {
    std::vector<std::vector<Eigen::Index>> longer;
    for (const std::vector<Eigen::Index>& set : sets)
      for (unsigned axes = 1; axes < 8; ++axes) {
        longer.push_back(set);
        for (unsigned axis = 0; axis < 3; ++axis)
          if ((axes >> axis & 1U) != 0) longer.back().push_back(3 * effect + axis);
      }
    sets = std::move(longer);
  }
  return sets;
}

/// Twice the logarithm of the mean of what `twice_logarithms` are of.
double meanEvidence(const std::vector<double>& twice_logarithms) {
  const double greatest = *std::ranges::max_element(twice_logarithms);
  double sum = 0;
  for (const double one : twice_logarithms) sum += std::exp((one - greatest) / 2);
  return greatest + 2 * std::log(sum / static_cast<double>(twice_logarithms.size()));
}

}  // namespace

RestingProblem::RestingProblem(const BodyCase& given, const RestingImu& imu, ImuSensor sensor, bool held_out)
    : given_{given}, imu_{imu}, sensor_{sensor}, logs_{restingReadings(given, sensor, held_out)} {
  const auto n = static_cast<Eigen::Index>(logs_.size());
  Eigen::VectorXd all(3 * n);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (Eigen::Index i = 0; i < n; ++i) {
      const RestingReading& log = logs_[static_cast<std::size_t>(i)];
      all[axis * n + i] = log.mean[axis];
      if (log.isKnown(axis)) known_.push_back(axis * n + i);
    }
  measured_ = all(known_);
  straight_ = noiseFor({1, 2, 3});
}

RestingProblem::Noise RestingProblem::noiseFor(const std::array<int, 3>& map) const {
  const Eigen::MatrixXd covariance = restingCovariance(given_, imu_, sensor_, logs_, matrixOf(map))(known_, known_);
  Eigen::MatrixXd factor = covariance.llt().matrixL();
  const double log_determinant = 2 * factor.diagonal().array().log().sum();
  return {std::move(factor), log_determinant};
}

Eigen::VectorXd RestingProblem::whitened(const RestingImu::Deviation& deviation, const Noise& noise) const {
  const auto n = static_cast<Eigen::Index>(logs_.size());
  Eigen::VectorXd expected(3 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector3d reading = imu_.reading(sensor_, logs_[static_cast<std::size_t>(i)].up, deviation);
    for (Eigen::Index axis = 0; axis < 3; ++axis) expected[axis * n + i] = reading[axis];
  }
  return noise.factor.triangularView<Eigen::Lower>().solve(measured_ - expected(known_));
}

double RestingProblem::misfitOf(const SensorFit& fit) const {
  const Noise noise = noiseFor(fit.map);
  return whitened(fit.deviation, noise).squaredNorm() + noise.log_determinant - straight_.log_determinant;
}

double RestingProblem::solve(SensorFit& fit, const std::vector<Eigen::Index>& free, const Noise& noise) const {
  const Eigen::Index numbers = 3 * (std::ssize(fit.effects) - std::ranges::count_if(fit.effects, isMap));
  const auto at = [&](const Eigen::VectorXd& x) { return whitened(deviationOf(fit, x), noise); };
  const Eigen::Index count = std::ssize(free);
  fit.values = Eigen::VectorXd::Zero(numbers);
  Eigen::VectorXd z = at(fit.values);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Identity(count, count);
  for (int step = 0; step < kIterations && count > 0; ++step) {
    Eigen::MatrixXd jacobian(z.size(), count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::VectorXd there =
          fit.values + kDifference * Eigen::VectorXd::Unit(numbers, free[static_cast<std::size_t>(k)]);
      jacobian.col(k) = (at(there) - z) / kDifference;
    }
    normal = jacobian.transpose() * jacobian + Eigen::MatrixXd::Identity(count, count);
    const Eigen::VectorXd moves = normal.ldlt().solve(jacobian.transpose() * z + fit.values(free));
    fit.values(free) -= moves;
    z = at(fit.values);
    if (moves.norm() < kConverged) break;
  }
  fit.deviation = deviationOf(fit, fit.values);
  fit.chi2 = z.squaredNorm();
  fit.sigmas = normal.inverse().diagonal().cwiseSqrt();  // of the free numbers
  return -fit.chi2 - (noise.log_determinant - straight_.log_determinant) - fit.values.squaredNorm() -
         2 * Eigen::MatrixXd{normal.llt().matrixL()}.diagonal().array().log().sum();
}

SensorFit RestingProblem::fit(std::vector<const SensorEffect*> effects) const {
  SensorFit out{.effects = std::move(effects)}, best;
  best.evidence = -std::numeric_limits<double>::infinity();
  const bool has_map = out.has(SensorEffect::Number::kMap);
  const std::vector<std::array<int, 3>> maps = has_map ? axisMaps() : std::vector{out.map};
  const auto sets = freeNumbers(std::ssize(out.effects) - (has_map ? 1 : 0));
  const auto names = static_cast<double>(sensorEffects().size());
  for (const std::array<int, 3>& map : maps) {
    out.map = map;
    const Noise noise = noiseFor(map);
    std::vector<double> evidences;
    for (const std::vector<Eigen::Index>& free : sets)
      evidences.push_back(solve(out, free, noise));  // all free at last
    out.evidence = meanEvidence(evidences) - 2 * static_cast<double>(out.effects.size()) * std::log(names) -
                   2 * std::log(static_cast<double>(maps.size()));
    if (std::abs(out.evidence - best.evidence) < kSameEvidence * (1 + std::abs(best.evidence)))
      ++best.maps_alike;
    else if (out.evidence > best.evidence)
      best = out;
  }
  Eigen::Index number = 0;
  for (const SensorEffect* const effect : best.effects) {
    if (isMap(effect)) continue;
    best.values.segment<3>(number) *= effect->prior_sigma;
    best.sigmas.segment<3>(number) *= effect->prior_sigma;
    if (effect->number == SensorEffect::Number::kScale) best.values.segment<3>(number).array() += 1;
    number += 3;
  }
  return best;
}

}  // namespace darwinop::gap
