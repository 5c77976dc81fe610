#include "gap/identify/ripple_starts.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gap/case/median.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

/// Ends of all windows of the fitted logs, measured - simulated, rad; NaN where a window does not count.
Eigen::VectorXd endsOf(const FittedModel& present, const Hypothesis& hypothesis) {
  const Case& data = present.study->data;
  const Plant& plant = present.study->plant;
  const ShootingOptions windows{
      .length_s = thresholds::kRippleWindow, .stride_s = thresholds::kRippleWindow, .mixed = false};
  std::vector<Eigen::VectorXd> logs;
  Eigen::Index size = 0;
  for (const std::size_t i : present.evidence->logs) {
    logs.push_back(
        plant.blockResiduals(Block::kPlant, plant.places().front(), data, data.logs[i], hypothesis, windows).residual);
    size += logs.back().size();
  }
  Eigen::VectorXd all(size);
  for (Eigen::Index at = 0; const Eigen::VectorXd& log : logs) {
    all.segment(at, log.size()) = log;
    at += log.size();
  }
  return all;
}

Hypothesis rippled(Hypothesis hypothesis, const twin::EffectInfo& ripple, double count, double phase) {
  hypothesis.with(ripple).values = {thresholds::kRippleTorque, count, phase};
  return hypothesis;
}

struct Ripple {
  double amplitude = 0, phase = 0;
  double explained = 0;  // of a cost in which an outlier counts little
};

/// Robust least squares over the windows. Amplitude 0: no window responds to this ripple.
Ripple fitted(const Eigen::VectorXd& ends, const Eigen::MatrixX2d& change, double usual) {
  Eigen::Vector2d amount = Eigen::Vector2d::Zero();
  const auto left = [&]() -> Eigen::ArrayXd { return (ends + change * amount).array() / usual; };
  const double before = (1 + left().square()).log().sum();
  for (int i = 0; i < thresholds::kRippleReweightings; ++i) {
    const Eigen::VectorXd weight = 1 / (1 + left().square());
    const Eigen::Matrix2d gram = change.transpose() * weight.asDiagonal() * change;
    if (!(gram.determinant() > 1e-18)) return {};
    amount = -gram.ldlt().solve(change.transpose() * weight.asDiagonal() * ends);
  }
  return {.amplitude = thresholds::kRippleTorque * amount.norm(),
          .phase = std::atan2(amount[1], amount[0]),
          .explained = before - (1 + left().square()).log().sum()};
}

}  // namespace

bool isRipple(const twin::EffectInfo& effect) {
  return twin::indexOf(effect, twin::ParameterRole::kRippleTorque) == 0;
}

std::vector<Candidate> ripplesOf(const FittedModel& present) {
  Hypothesis hypothesis = present.hypothesis();
  const twin::EffectInfo* const ripple = twin::effectWith(twin::ParameterRole::kRippleTorque);
  if (ripple == nullptr || hypothesis.find(ripple->id) != nullptr) return {};
  hypothesis.servo.firmware_period_s = std::max(hypothesis.servo.firmware_period_s, thresholds::kRipplePeriod);
  const Eigen::VectorXd ends = endsOf(present, hypothesis);
  const Eigen::VectorXd sizes = ends.cwiseAbs();
  const double usual = 2 * medianOf({sizes.begin(), sizes.end()});
  if (!(usual > 0)) return {};

  std::array<Ripple, thresholds::kMaxRipplesPerTurn + 1> ripples;
  forEach(thresholds::kMaxRipplesPerTurn, [&](std::size_t i) {
    const double count = static_cast<double>(i + 1);
    Eigen::MatrixX2d change(ends.size(), 2);
    for (const int phase : {0, 1})
      change.col(phase) = endsOf(present, rippled(hypothesis, *ripple, count, phase * std::numbers::pi / 2)) - ends;
    Eigen::VectorXd known = ends;
    for (Eigen::Index k = 0; k < ends.size(); ++k)
      if (std::isnan(ends[k]) || !change.row(k).allFinite()) known[k] = 0, change.row(k).setZero();
    ripples[i + 1] = fitted(known, change, usual);
  });

  std::vector<Candidate> starts;
  for (std::size_t i = 0; i < thresholds::kRippleCandidates; ++i) {
    std::size_t best = 0;
    for (std::size_t count = 1; count <= thresholds::kMaxRipplesPerTurn; ++count) {
      const bool apart = std::ranges::all_of(
          starts, [&](const Candidate& other) { return std::abs(other.values[1] - static_cast<double>(count)) > 1; });
      if (apart && ripples[count].explained > ripples[best].explained) best = count;
    }
    if (best == 0) break;
    starts.push_back(
        {ripple, {std::clamp(ripples[best].amplitude, 1e-4, 0.15), static_cast<double>(best), ripples[best].phase}});
  }
  return starts;
}

}  // namespace darwinop::gap
