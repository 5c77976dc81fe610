// What can be simulated. One implementation: gap/plant/bench, a servo that swings an arm.
#pragma once

#include <span>

#include "gap/plant/block.hpp"
#include "gap/plant/block_residuals.hpp"
#include "gap/plant/trace.hpp"

namespace darwinop::gap {

/// Stateless: every function may run in several threads at once.
class Plant {
 public:
  Plant() = default;
  Plant(const Plant&) = delete;
  Plant& operator=(const Plant&) = delete;
  virtual ~Plant() = default;

  /// Columns of a trace, in this order.
  [[nodiscard]] virtual std::span<const Signal> signals() const = 0;
  /// Where effects may act. A hypothesis may have each effect once a place.
  [[nodiscard]] virtual std::span<const Place> places() const = 0;
  /// Blocks of the loop of a joint, in the order of the signal flow.
  [[nodiscard]] virtual std::span<const Block> blocks() const = 0;

  /// Closed-loop simulation of a log: the same commands at the same times, on a hypothesis. Reuses the memory of
  /// `trace`. Throws std::runtime_error for a hypothesis that is impossible (no inertia left).
  virtual void rollOut(const Case& given, std::size_t log, const Hypothesis& hypothesis, const RollOutOptions& options,
                       Trace& trace) const = 0;

  /// Residuals of one block at one place, from its measured input and output; no closed loop is simulated. NaN where
  /// the log does not measure them. `options`: of the block kPlant.
  [[nodiscard]] virtual BlockResiduals blockResiduals(Block block, const Place& place, const Case& given,
                                                      const Trajectory& log, const Hypothesis& hypothesis,
                                                      const ShootingOptions& options) const = 0;
};

/// The plant that the logs of a case are of. Every case is of a bench today, so gap/plant/bench defines it.
const Plant& plantOf(const Case& given);

}  // namespace darwinop::gap
