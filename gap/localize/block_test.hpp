// Significance test of a block's residuals against those of simulated repeats of the baseline.
#pragma once

#include <vector>

#include "gap/fit/unknown.hpp"
#include "gap/localize/simulated_repeats.hpp"
#include "gap/plant/block_residuals.hpp"

namespace darwinop::gap {

struct BlockTest {
  std::vector<BlockResiduals> samples;  // one for each log, with z
  double rms = 0, expected_rms = 0;     // in the unit of the block; NaN without samples
  double cost = 0;                      // sum of costOf(z)
  double expected_cost = 0;             // its mean over the simulated repeats
  double significance = 0;  // greatest of: mean cost, that of the worst log, of the worst quarter second; in sigmas
  double moved = 0;         // significance of the moves of the baseline numbers, in standard deviations
  [[nodiscard]] bool known() const;
  [[nodiscard]] bool isOpen() const;
};

/// `numbers`: baseline numbers that may move within their priors (nuisancesOf()).
BlockTest judge(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                const SimulatedRepeats& copies, const Hypothesis& hypothesis, const std::vector<Unknown>& numbers);

/// The cost of a tested block under another hypothesis: same sigmas, no numbers moved.
double blockCostUnder(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                      const BlockTest& judged, const Hypothesis& other);

}  // namespace darwinop::gap
