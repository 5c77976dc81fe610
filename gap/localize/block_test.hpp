// Whether a cut is closed: its residuals against those of the same cut through roll-outs of the baseline with noise.
#pragma once

#include <vector>

#include "gap/fit/unknown.hpp"
#include "gap/localize/simulated_repeats.hpp"
#include "gap/plant/bench/block_residuals.hpp"

namespace darwinop::gap {

struct BlockTest {
  std::vector<BlockResiduals> samples;  // a log each, with z
  double rms = 0, expected_rms = 0;     // in the unit of the cut; NaN when no sample counts
  double cost = 0;                      // sum of costOf(z)
  double expected_cost = 0;             // its mean over the copies
  double significance = 0;  // greatest of: mean cost, that of the worst log, of the worst quarter second; in sigmas
  double moved = 0;         // how far the numbers had to move inside their priors; in standard deviations
  [[nodiscard]] bool known() const;
  [[nodiscard]] bool isOpen() const;
};

/// `numbers`: that may move inside their priors (nuisancesOf()); without effect on the cut they cost nothing.
BlockTest judge(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                const SimulatedRepeats& copies, const Hypothesis& hypothesis, const std::vector<Unknown>& numbers);

/// The cost of a judged cut under another hypothesis: same sigmas, no numbers moved.
double blockCostUnder(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                      const BlockTest& judged, const Hypothesis& other);

}  // namespace darwinop::gap
