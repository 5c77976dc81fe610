// Tests the blocks of one case, one after the other: findBlocks() with its state.
#pragma once

#include <string>
#include <vector>

#include "gap/fit/unknown.hpp"
#include "gap/localize/blocks.hpp"
#include "gap/localize/command_split.hpp"

namespace darwinop::gap {

/// Refers to its arguments.
class BlockFinder {
 public:
  BlockFinder(const Plant& plant, const Case& given, const Hypothesis& baseline, const std::vector<std::size_t>& logs,
              const SimulatedRepeats& copies);

  /// Once only.
  Blocks find();

 private:
  /// At the place of the case's joint.
  [[nodiscard]] BlockResiduals residuals(Block block, const Trajectory& log, const Hypothesis& hypothesis,
                                         const ShootingOptions& options = {}) const;
  [[nodiscard]] BlockTest judged(const BlockResidualFunction& cut, bool priors = true) const;
  [[nodiscard]] BlockTest judgedWith(const BlockResidualFunction& cut, const Hypothesis& hypothesis) const;

  void take(Block block, BlockTest judgement, const std::string& unit, double per_unit);
  void notCut(Block block, const std::string& why) { out_.of(block).detail = why; }

  void supply();
  void sensor();

  // Controller, command and plant, by what the logs have: block_finder_law.cpp.
  void lawByItsDuty();
  /// Law speed_p has no duty: the motor takes the commanded speed at once.
  void lawAndMotorAtOnce();
  void noDuty();
  /// `without`: before findings in other blocks were applied. A small remainder is the error of that finding.
  void takePlant(const BlockTest& without, BlockTest with, const std::string& how);
  /// No signal is measured between command and controller; the finding is assigned to one of the two.
  void share(const CommandSplit& split, bool open);
  [[nodiscard]] double dutyPerTick() const;

  const Plant& plant_;
  const Case& given_;
  const std::vector<std::size_t>& logs_;
  const SimulatedRepeats& copies_;
  const Hypothesis& baseline_;
  std::vector<Unknown> numbers_;
  Blocks out_;
};

}  // namespace darwinop::gap
