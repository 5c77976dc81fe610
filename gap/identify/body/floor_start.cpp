#include "gap/identify/body/floor_start.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

FloorSet with(FloorSet set, PlacedFloor placed) {
  set.push_back(std::move(placed));
  return set;
}

/// Residuals without an effect, and by how much each of its starts lowers them.
struct Linearized {
  Eigen::VectorXd base;
  Eigen::MatrixXd changes;

  [[nodiscard]] Linearized rows(Eigen::Index begin, Eigen::Index count) const {
    return {base.segment(begin, count), changes.middleRows(begin, count)};
  }
  /// Factors on the starts.
  [[nodiscard]] Eigen::VectorXd solution() const {
    Eigen::MatrixXd normal = changes.transpose() * changes;
    normal.diagonal().array() += 1;
    return normal.ldlt().solve(changes.transpose() * base);
  }
  /// Of the squared residuals.
  [[nodiscard]] double explainedBy(const Eigen::VectorXd& factors) const {
    return 1 - (base - changes * factors).squaredNorm() / base.squaredNorm();
  }
};

Linearized linearized(FloorEvaluator& evaluator, const FloorSet& found, const std::vector<FloorSet>& starts) {
  Linearized out{.base = evaluator.residuals({found}).front(), .changes = {}};
  const std::vector<Eigen::VectorXd> moved = evaluator.residuals(starts);
  out.changes.resize(out.base.size(), std::ssize(starts));
  for (std::size_t i = 0; i < starts.size(); ++i) out.changes.col(static_cast<Eigen::Index>(i)) = out.base - moved[i];
  return out;
}

std::vector<double> valuesAt(const FloorEffect& effect, const Eigen::VectorXd& factors) {
  std::vector<double> values = effect.neutral;
  for (std::size_t k = 0; k < values.size(); ++k) {
    for (std::size_t i = 0; i < effect.starts.size(); ++i)
      values[k] += factors[static_cast<Eigen::Index>(i)] * (effect.starts[i][k] - effect.neutral[k]);
    values[k] = std::clamp(values[k], effect.numbers[k].low, effect.numbers[k].high);
  }
  return values;
}

/// A walk that an effect led elsewhere is not linear in it, and outweighs logs that are: squats, a robot that lies
/// still.
std::vector<FloorSet> linearStarts(FloorEvaluator& evaluator, const FloorSet& found, const FloorEffect& effect,
                                   const std::vector<FloorSet>& starts) {
  const Linearized of_all = linearized(evaluator, found, starts);
  const Eigen::VectorXd factors = of_all.solution();
  std::vector<FloorSet> out;
  for (const double share : {1.0, 0.5}) out.push_back(with(found, {&effect, valuesAt(effect, share * factors)}));
  for (const FloorLogRows& log : evaluator.rowsOfLogs()) {
    const Linearized alone = of_all.rows(log.begin, log.rows);
    const Eigen::VectorXd own = alone.solution();
    if (alone.explainedBy(own) > thresholds::kFloorStartShare)
      out.push_back(with(found, {&effect, valuesAt(effect, own)}));
  }
  return out;
}

}  // namespace

FloorStart bestStart(FloorEvaluator& evaluator, const FloorSet& found, const FloorEffect& effect) {
  std::vector<FloorSet> sets;
  for (const std::vector<double>& start : effect.starts) sets.push_back(with(found, {&effect, start}));
  if (effect.is_linear) sets = linearStarts(evaluator, found, effect, sets);
  const std::vector<Eigen::VectorXd> residuals = evaluator.residuals(sets);
  FloorStart best;
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (const double cost = costOf(sets[i], residuals[i]); i == 0 || cost < best.cost) best = {sets[i], cost};
  return best;
}

}  // namespace darwinop::gap
