// Interface of a plant: what can be simulated. gap/plants.cpp lists the implementations.
#pragma once

#include <span>

#include "gap/plant/block.hpp"
#include "gap/plant/block_residuals.hpp"
#include "gap/plant/hypothesis.hpp"
#include "gap/plant/trace.hpp"

namespace darwinop::gap {

/// Stateless: every function may run in several threads at once.
class Plant {
 public:
  Plant() = default;
  Plant(const Plant&) = delete;
  Plant& operator=(const Plant&) = delete;
  virtual ~Plant() = default;

  /// Columns of a trace, in this order. The first kJointSignals are of the first joint.
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

  /// Slope of the supply voltage at one place against the current that it draws, over all of `logs`, ohm; a constant
  /// offset of the voltage does not matter. NaN where the logs do not determine it.
  [[nodiscard]] virtual double supplyResistance(const Place& place, const Case& given,
                                                const std::vector<const Trajectory*>& logs,
                                                const Hypothesis& hypothesis) const = 0;
};

}  // namespace darwinop::gap
