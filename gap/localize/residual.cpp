#include "gap/localize/residual.hpp"

#include <cmath>
#include <stdexcept>

#include "gap/localize/absorb.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Positions of one log, in standard deviations of independent samples.
Eigen::VectorXd whitened(const Study& study, std::size_t i, const Hypothesis& hypothesis, Trace& trace) {
  const Case& given = study.data;
  const Evidence& evidence = study.evidence;
  Eigen::VectorXd all(evidence.noise[i].size());
  study.plant.rollOut(given, evidence.logs[i], hypothesis, {}, trace);
  evidence.noise[i].residuals(given.logs[evidence.logs[i]], trace, all);
  return all.head(all.size() / 2);
}

}  // namespace

double LogResidual::squareSum() const {
  if (known() == static_cast<double>(position_rad.size())) return position_rad.squaredNorm();
  double sum = 0;
  for (const double residual : position_rad)
    if (!std::isnan(residual)) sum += residual * residual;
  return sum;
}

double LogResidual::known() const {
  return static_cast<double>(position_rad.size() - position_rad.array().isNaN().count());
}

std::vector<LogResidual> residualsOf(const Study& study, const NoiseFloor& floor) {
  const Case& given = study.data;
  const Evidence& evidence = study.evidence;
  const Hypothesis& baseline = study.baseline;
  const std::vector<Unknown> numbers = nuisancesOf(given, baseline);
  std::vector<LogResidual> out(evidence.logs.size());
  std::vector<Eigen::MatrixXd> jacobians(out.size());
  forEach(out.size(), [&](std::size_t i) {
    Trace trace;
    LogResidual& one = out[i];
    one.log = evidence.logs[i];
    one.z = whitened(study, i, baseline, trace);
    one.position_rad.resize(one.z.size());
    for (Eigen::Index k = 0; k < one.z.size(); ++k) {
      const auto row = static_cast<std::size_t>(k);
      one.position_rad[k] = given.logs[one.log].position_rad[row] - trace[kPositionSignal][row];
    }
    one.rms_rad = std::sqrt(one.squareSum() / one.known());
    one.floors = one.rms_rad / floor.logs[i].rms_rad;
    jacobians[i].setZero(one.z.size(), static_cast<Eigen::Index>(numbers.size()));
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const double moved =
          numbers[k].toSearch(numbers[k].expected + thresholds::kNuisanceStepSigmas * numbers[k].sigma);
      const Eigen::VectorXd there = whitened(study, i, applied(baseline, {numbers[k]}, &moved), trace);
      jacobians[i].col(static_cast<Eigen::Index>(k)) = (one.z - there) / thresholds::kNuisanceStepSigmas;
    }
  });
  Eigen::Index rows = 0;
  for (const LogResidual& one : out) rows += one.z.size();
  Eigen::VectorXd z(rows);
  Eigen::MatrixXd all(rows, static_cast<Eigen::Index>(numbers.size()));
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < out.size(); at += out[i].z.size(), ++i) {
    z.segment(at, out[i].z.size()) = out[i].z;
    all.middleRows(at, out[i].z.size()) = jacobians[i];
  }
  z = absorb(z, all).left;
  at = 0;
  for (LogResidual& one : out) {
    const Eigen::Index n = one.z.size();
    one.z = z.segment(at, n);
    at += n;
  }
  return out;
}

}  // namespace darwinop::gap
