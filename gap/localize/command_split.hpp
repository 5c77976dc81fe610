// Decides between command and controller: no measured signal lies between the two blocks.
#pragma once

#include <string>

#include "gap/localize/block_test.hpp"

namespace darwinop::gap {

/// The part that changes in one block explain.
struct Explained {
  double share = 0;       // of the cost beyond the noise
  Hypothesis hypothesis;  // the baseline with the changes
};

struct CommandSplit {
  Explained by_command, by_controller;
  double at_rest = 0;  // that cost of a sample whose goal is at rest, of the mean: a motion profile leaves none there
  [[nodiscard]] bool isCommand() const;
  [[nodiscard]] const Explained& best() const { return isCommand() ? by_command : by_controller; }
};

/// Tries effects that delay or slow the goal, and effects of the controller, at a few values, and the best with one
/// more.
CommandSplit splitCommand(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                          const BlockTest& judged, const Hypothesis& hypothesis);

/// By a delay of the goal alone, from residuals of the plant, which resolve less than one row.
Explained explainByDelay(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                         const BlockTest& judged, const Hypothesis& hypothesis);

}  // namespace darwinop::gap
