// Levenberg and Marquardt with differences; a scale is searched in its logarithm.
#include "gap/identify/body/mechanics_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

using Number = MechanicalEffect::Number;

struct Coordinate {
  std::size_t effect, number;
};

constexpr double kDifferenceShare = 0.03;  // of a number's typical size
constexpr double kLeastGain = 0.05;        // cost
constexpr double kMostDamping = 1e6;

double leastOf(const Number& number) {
  return number.neutral == 0 ? thresholds::kSmallestScale * number.high : number.low;
}

double coordinateOf(const Number& number, double value) {
  return number.is_logarithmic ? std::log(std::max(value, leastOf(number))) : value;
}

double valueOf(const Number& number, double coordinate) {
  return std::clamp(number.is_logarithmic ? std::exp(coordinate) : coordinate, number.low, number.high);
}

double stepOf(const Number& number) {
  if (number.is_logarithmic) return kDifferenceShare;
  if (number.prior_sigma > 0) return kDifferenceShare * number.prior_sigma;
  const double typical = std::abs(number.typical - number.neutral);
  return kDifferenceShare * (typical > 0 ? typical : (number.high - number.low) / 4);
}

class Search {
 public:
  Search(const ResidualsOfEffects& residuals_of, std::vector<PlacedMechanics> effects,
         const std::vector<std::size_t>& free, bool secondary, double rows_alike)
      : of_{residuals_of}, fit_{.effects = std::move(effects), .sigmas = {}}, rows_alike_{rows_alike} {
    for (const std::size_t effect : free) {
      for (std::size_t number = 0; number < fit_.effects[effect].effect->numbers.size(); ++number) {
        const Number& of = numberOf({effect, number});
        if (!of.is_secondary || of.prior_sigma > 0 || secondary) coordinates_.push_back({effect, number});
      }
    }
    for (const PlacedMechanics& effect : fit_.effects) fit_.sigmas.emplace_back(effect.values.size(), 0.0);
    fit_.numbers = coordinates_.size();
  }

  MechanicsFit run(int iterations);

 private:
  [[nodiscard]] const Number& numberOf(const Coordinate& at) const {
    return fit_.effects[at.effect].effect->numbers[at.number];
  }
  [[nodiscard]] std::vector<PlacedMechanics> at(const Eigen::VectorXd& x) const {
    std::vector<PlacedMechanics> effects = fit_.effects;
    for (std::size_t i = 0; i < coordinates_.size(); ++i)
      effects[coordinates_[i].effect].values[coordinates_[i].number] =
          valueOf(numberOf(coordinates_[i]), x[static_cast<Eigen::Index>(i)]);
    return effects;
  }
  [[nodiscard]] Eigen::VectorXd residuals(const Eigen::VectorXd& x) const;
  [[nodiscard]] double cost(const Eigen::VectorXd& residuals) const { return robustCost(residuals); }
  [[nodiscard]] double excessOf(const Eigen::VectorXd& data) const;
  void setSigmas(const Eigen::VectorXd& x, const Eigen::MatrixXd& information);

  const ResidualsOfEffects& of_;
  MechanicsFit fit_;
  double rows_alike_;
  std::vector<Coordinate> coordinates_;
};

/// Of the data, then of the priors.
Eigen::VectorXd Search::residuals(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd data = of_(at(x));
  const Eigen::Index from = data.size();
  Eigen::VectorXd out = Eigen::VectorXd::Zero(from + x.size());
  out.head(from) = data;
  for (std::size_t i = 0; i < coordinates_.size(); ++i)
    if (const Number& number = numberOf(coordinates_[i]); number.prior_sigma > 0)
      out[from + static_cast<Eigen::Index>(i)] =
          (x[static_cast<Eigen::Index>(i)] - number.neutral) / number.prior_sigma;
  return out;
}

/// What no model explains is not noise: cost of the data over that of a right model, at least 1.
double Search::excessOf(const Eigen::VectorXd& data) const {
  const double of_noise = static_cast<double>(data.size()) * rows_alike_ / thresholds::kCorrelatedSamples;
  return std::max(1.0, robustCost(data) / of_noise);
}

MechanicsFit Search::run(int iterations) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(coordinates_.size()));
  for (std::size_t i = 0; i < coordinates_.size(); ++i)
    x[static_cast<Eigen::Index>(i)] =
        coordinateOf(numberOf(coordinates_[i]), fit_.effects[coordinates_[i].effect].values[coordinates_[i].number]);
  Eigen::VectorXd z = residuals(x);
  fit_.cost = cost(z);
  double damping = 1e-2;
  Eigen::MatrixXd of_data = Eigen::MatrixXd::Identity(x.size(), x.size()), of_priors = 0 * of_data;
  for (int iteration = 0; iteration < iterations && x.size() > 0; ++iteration) {
    Eigen::MatrixXd jacobian(z.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const Number& number = numberOf(coordinates_[static_cast<std::size_t>(i)]);
      double step = stepOf(number);
      // Away from the bound, where a number has no effect.
      if (valueOf(number, x[i] + step) == valueOf(number, x[i])) step = -step;
      Eigen::VectorXd moved = x;
      moved[i] += step;
      jacobian.col(i) = (residuals(moved) - z) / step;
    }
    const Eigen::VectorXd weight = robustWeights(z);
    const auto informationIn = [&](Eigen::Index from, Eigen::Index rows) -> Eigen::MatrixXd {
      const auto part = jacobian.middleRows(from, rows);
      return part.transpose() * weight.segment(from, rows).asDiagonal() * part;
    };
    of_data = informationIn(0, z.size() - x.size()), of_priors = informationIn(z.size() - x.size(), x.size());
    const Eigen::VectorXd slope = jacobian.transpose() * weight.cwiseProduct(z);
    const double before = fit_.cost;
    for (; damping < kMostDamping; damping *= 10) {
      Eigen::MatrixXd left = of_data + of_priors;
      left.diagonal() *= 1 + damping;
      left.diagonal().array() += 1e-9;
      Eigen::VectorXd next = x - left.ldlt().solve(slope);
      for (Eigen::Index i = 0; i < x.size(); ++i) {
        const Number& number = numberOf(coordinates_[static_cast<std::size_t>(i)]);
        next[i] = coordinateOf(number, valueOf(number, next[i]));
      }
      Eigen::VectorXd there = residuals(next);
      const double cost_there = cost(there);
      if (!(cost_there < fit_.cost)) continue;
      x = next, z = std::move(there), fit_.cost = cost_there;
      damping = std::max(1e-6, damping / 10);
      break;
    }
    if (before - fit_.cost < kLeastGain) break;
  }
  fit_.effects = at(x);
  if (x.size() > 0) setSigmas(x, of_data / (rows_alike_ * excessOf(z.head(z.size() - x.size()))) + of_priors);
  return fit_;
}

void Search::setSigmas(const Eigen::VectorXd& x, const Eigen::MatrixXd& information) {
  const Eigen::MatrixXd covariance = (information + 1e-9 * Eigen::MatrixXd::Identity(x.size(), x.size())).inverse();
  for (std::size_t i = 0; i < coordinates_.size(); ++i) {
    const Number& number = numberOf(coordinates_[i]);
    const auto k = static_cast<Eigen::Index>(i);
    const double value = valueOf(number, x[k]);
    const double sigma = std::sqrt(std::max(0.0, covariance(k, k))) * (number.is_logarithmic ? value : 1);
    const double finest = thresholds::kFinestInterval / thresholds::kInterval90 * std::abs(value - number.neutral);
    fit_.sigmas[coordinates_[i].effect][coordinates_[i].number] = std::max(sigma, finest);
  }
}

}  // namespace

BodyHypothesis with(const ClampedRobot& robot, const std::vector<PlacedMechanics>& effects) {
  BodyHypothesis out = robot.baseline();
  for (const PlacedMechanics& effect : effects) effect.applyTo(out);
  return out;
}

std::vector<std::size_t> limbsOf(const ClampedRobot& robot, const std::vector<PlacedMechanics>& effects) {
  std::vector<std::size_t> out;
  for (const PlacedMechanics& effect : effects)
    for (const Joint joint : effect.joints)
      if (std::ranges::find(out, robot.limbOf(joint)) == out.end()) out.push_back(robot.limbOf(joint));
  return out;
}

double robustCost(const Eigen::VectorXd& whitened) {
  constexpr double kLimit = thresholds::kRobustSigmas;
  double sum = 0;
  for (const double one : whitened) sum += 2 * kLimit * kLimit * (std::sqrt(1 + std::pow(one / kLimit, 2)) - 1);
  return sum;
}

Eigen::VectorXd robustWeights(const Eigen::VectorXd& whitened) {
  return (1 + (whitened.array() / thresholds::kRobustSigmas).square()).rsqrt();
}

MechanicsFit fitEffects(const ResidualsOfEffects& residuals, std::vector<PlacedMechanics> effects,
                        const std::vector<std::size_t>& free, bool secondary, int iterations, double rows_alike) {
  return Search{residuals, std::move(effects), free, secondary, rows_alike}.run(iterations);
}

MechanicsFit fitMechanics(const ClampedRobot& robot, std::vector<PlacedMechanics> effects,
                          const std::vector<std::size_t>& free, bool secondary, int iterations) {
  std::vector<PlacedMechanics> moved;
  for (const std::size_t effect : free) moved.push_back(effects[effect]);
  const std::vector<std::size_t> limbs = limbsOf(robot, moved);
  const ResidualsOfEffects of = [&](const std::vector<PlacedMechanics>& placed) {
    const BodyHypothesis hypothesis = with(robot, placed);
    Eigen::VectorXd out;
    for (const std::size_t limb : limbs) {
      const Eigen::VectorXd part = robot.residuals(limb).of(hypothesis);
      out.conservativeResize(out.size() + part.size());
      out.tail(part.size()) = part;
    }
    return out;
  };
  return fitEffects(of, std::move(effects), free, secondary, iterations, thresholds::kCorrelatedSamples);
}

}  // namespace darwinop::gap
