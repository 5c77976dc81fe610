#include "gap/identify/body/controller_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/localize/absorb.hpp"
#include "gap/plant/body/joint_alone.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr double kUnknownSigma = std::numeric_limits<double>::infinity();

BlockResiduals lawOf(const BodyCase& given, std::size_t log, const Hypothesis& servos) {
  return jointResiduals(Block::kController, given, given.joints.logs[log], servos);
}

}  // namespace

ControllerResiduals::ControllerResiduals(const BodyCase& given, bool held_out) : given_{given} {
  const Hypothesis robot = bodyBaselineOf(given);
  for (const Unknown& number : nuisancesOf(given.joints, robot))
    if (number.name == "duty_per_kp") gain_ = number;
  for (std::size_t i = 0; i < given.joints.logs.size(); ++i) {
    const Trajectory& log = given.joints.logs[i];
    if (log.held_out != held_out) continue;
    Samples& samples = joints_[static_cast<std::size_t>(log.joint.value())];
    const BlockResiduals base = lawOf(given, i, robot);
    samples.logs.push_back(i);
    const Eigen::Index begin = samples.sigma.size();
    samples.sigma.conservativeResize(begin + base.residual.size());
    for (Eigen::Index k = 0; k < base.residual.size(); ++k) {
      const bool is_known = std::isfinite(base.residual[k]);
      samples.sigma[begin + k] = is_known ? base.sigma[k] : kUnknownSigma;
      samples.count += is_known ? 1 : 0;
    }
  }
}

Eigen::VectorXd ControllerResiduals::raw(const Samples& samples, const Hypothesis& servos) const {
  Eigen::VectorXd out(samples.sigma.size());
  Eigen::Index begin = 0;
  for (const std::size_t log : samples.logs) {
    const BlockResiduals there = lawOf(given_, log, servos);
    out.segment(begin, there.residual.size()) = there.residual;
    begin += there.residual.size();
  }
  for (Eigen::Index k = 0; k < out.size(); ++k) {
    if (!std::isfinite(samples.sigma[k]))
      out[k] = 0;
    else  // an effect that says nothing of a load that is known explains nothing
      out[k] = std::isfinite(out[k]) ? out[k] / samples.sigma[k] : thresholds::kImpossibleSigmas;
  }
  return out / std::sqrt(thresholds::kCorrelatedSamples);
}

Eigen::VectorXd ControllerResiduals::of(Joint joint, const Hypothesis& servos) const {
  const Samples& samples = joints_[static_cast<std::size_t>(joint)];
  Eigen::VectorXd out = raw(samples, servos);
  if (!gain_ || out.size() == 0) return out;
  const double x = gain_->toSearch(gain_->expected + thresholds::kPriorStep * gain_->sigma);
  const Eigen::VectorXd along = (raw(samples, applied(servos, {*gain_}, &x)) - out) / thresholds::kPriorStep;
  const double variance = along.squaredNorm();
  if (variance > 0) out -= along * (1 - 1 / std::sqrt(1 + variance)) * along.dot(out) / variance;
  return out;
}

double ControllerResiduals::significance(Joint joint, const Hypothesis& servos) const {
  const double samples = joints_[static_cast<std::size_t>(joint)].count / thresholds::kCorrelatedSamples;
  return samples > 1 ? sigmasOfChiSquared(of(joint, servos).squaredNorm(), samples) : 0;
}

}  // namespace darwinop::gap
