// Predicts the gain of two effects together, where neither may have any alone.
#include <algorithm>
#include <cmath>

#include "gap/identify/ripple_starts.hpp"
#include "gap/identify/screen.hpp"

namespace darwinop::gap {
namespace {

constexpr double kMostOfAChange = 1.3;  // as for a single candidate

/// Squares that two changes remove together, each with a share of 0 to kMostOfAChange: one share after the other until
/// neither moves.
double gainOfTwo(const Eigen::Matrix2d& gram, const Eigen::Vector2d& along) {
  constexpr int kRounds = 200;
  constexpr double kStill = 1e-9;
  Eigen::Vector2d share = Eigen::Vector2d::Zero();
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Vector2d before = share;
    for (const int k : {0, 1})
      share[k] = std::clamp((along[k] - gram(0, 1) * share[1 - k]) / gram(k, k), 0.0, kMostOfAChange);
    if ((share - before).cwiseAbs().maxCoeff() < kStill) break;
  }
  return 2 * share.dot(along) - share.dot(gram * share);
}

}  // namespace

std::vector<CandidatePair> Screen::pairs() const {
  std::vector<const Direction*> directions;
  for (const Direction& direction : directions_)
    if (!direction.either_way && direction.change.squaredNorm() > kLeastChange) directions.push_back(&direction);
  const auto count = static_cast<Eigen::Index>(directions.size());
  Eigen::MatrixXd changes(absorbed_.rows(), count);
  for (Eigen::Index i = 0; i < count; ++i) changes.col(i) = directions[static_cast<std::size_t>(i)]->change;
  const Eigen::MatrixXd gram = changes.transpose() * changes;
  const Eigen::VectorXd along = -changes.topRows(residuals_.size()).transpose() * residuals_;
  std::vector<CandidatePair> best;
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = i + 1; j < count; ++j) {
      const Candidate &one = directions[static_cast<std::size_t>(i)]->candidate,
                      &other = directions[static_cast<std::size_t>(j)]->candidate;
      if (one.effect == other.effect) continue;
      Eigen::Matrix2d two;
      two << gram(i, i), gram(i, j), gram(i, j), gram(j, j);
      const double gain = gainOfTwo(two, {along[i], along[j]});
      const auto known = std::ranges::find_if(best, [&](const CandidatePair& pair) {
        return pair.one.effect == one.effect && pair.other.effect == other.effect;
      });
      if (known == best.end())
        best.push_back({one, other, gain});
      else if (gain > known->predicted_gain)
        *known = {one, other, gain};
    }
  std::ranges::stable_sort(best, std::greater{}, &CandidatePair::predicted_gain);
  return best;
}

}  // namespace darwinop::gap
