// Noise of a limb by simulated repeats: what varies from row to row is a standard deviation of the row, what varies
// slowly a mode that counts once.
#include <cmath>

#include "core/registers.hpp"
#include "core/servo_limits.hpp"
#include "gap/localize/body/limb_residuals.hpp"
#include "gap/plant/registers.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Moving average over rows on either side, within one block.
Eigen::VectorXd smoothed(const Eigen::Ref<const Eigen::VectorXd>& of, int half) {
  Eigen::VectorXd out(of.size());
  for (Eigen::Index i = 0; i < of.size(); ++i) {
    const Eigen::Index from = std::max<Eigen::Index>(0, i - half), to = std::min(of.size() - 1, i + half);
    out[i] = of.segment(from, to - from + 1).mean();
  }
  return out;
}

}  // namespace

void LimbResiduals::estimateNoise(const BodyHypothesis& about) {
  constexpr int kRuns = thresholds::kLimbNoiseRuns;
  constexpr int kHalf = thresholds::kNoiseHalfWindow;
  const Eigen::VectorXd exact = simulated(about, nullptr);
  Eigen::MatrixXd spread(exact.size(), kRuns);
  for (int run = 0; run < kRuns; ++run) {
    const Disturbance noise{.seed = static_cast<std::uint64_t>(run + 1)};
    spread.col(run) = simulated(about, &noise) - exact;
  }
  spread = spread.unaryExpr([](double value) { return std::isfinite(value) ? value : 0.0; });
  constexpr double kRounding = kRoundingSigma * kRadPerTick;
  constexpr double kLoadCount = find(kMx28, "present_load").scale;
  sigma_ = Eigen::VectorXd::Ones(exact.size());
  directions_ = Eigen::MatrixXd::Zero(exact.size(), kRuns);
  for (const LimbSamples& block : blocks_) {
    if (block.is_load) {
      auto sigma = sigma_.segment(block.begin, block.rows);
      sigma.setConstant(std::max(kLoadCount, thresholds::kLawResidual));
      // Firmware that does not run in step with the rows is read a period earlier or later.
      if (!given_.logs[block.log].is_phase_known)
        sigma =
            (sigma.cwiseAbs2() + spread.middleRows(block.begin, block.rows).cwiseAbs2().rowwise().mean()).cwiseSqrt();
      continue;
    }
    Eigen::MatrixXd slow(block.rows, kRuns);
    Eigen::VectorXd fast = Eigen::VectorXd::Zero(block.rows), drift = fast;
    for (int run = 0; run < kRuns; ++run) {
      slow.col(run) = smoothed(spread.col(run).segment(block.begin, block.rows), kHalf);
      fast += (spread.col(run).segment(block.begin, block.rows) - slow.col(run)).cwiseAbs2() / kRuns;
    }
    fast = smoothed(fast, thresholds::kNoiseVarianceHalfWindow) * ((2 * kHalf + 1.0) / (2 * kHalf));
    fast = fast.cwiseMax(kRounding * kRounding);
    drift = smoothed(slow.cwiseAbs2().rowwise().mean(), thresholds::kNoiseVarianceHalfWindow);
    for (Eigen::Index row = 0; row < block.rows; ++row) {
      sigma_[block.begin + row] = std::sqrt(fast[row]);
      // A mean of seven independent samples has 0.14 of their variance.
      if (drift[row] < thresholds::kSlowNoiseShare * fast[row]) continue;
      directions_.row(block.begin + row) = slow.row(row) * (thresholds::kReleasedFactor / std::sqrt(kRuns * fast[row]));
    }
  }
  forgetUnmeasured(measured_, directions_);
  widenByWhatIsNotSpanned();
}

// A dozen repeats do not span all possible motions of a long free swing: the part of each repeat outside the span of
// the others is added to the noise of each sample.
void LimbResiduals::widenByWhatIsNotSpanned() {
  const Eigen::VectorXd left = notSpannedByOthers(directions_).cwiseAbs2().rowwise().sum();
  for (const LimbSamples& block : blocks_) {
    const Eigen::VectorXd factor =
        (1 + smoothed(left.segment(block.begin, block.rows), thresholds::kNoiseVarianceHalfWindow).array()).sqrt();
    sigma_.segment(block.begin, block.rows).array() *= factor.array();
    directions_.middleRows(block.begin, block.rows) =
        factor.cwiseInverse().asDiagonal() * directions_.middleRows(block.begin, block.rows);
  }
}

}  // namespace darwinop::gap
