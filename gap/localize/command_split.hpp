// Command or controller: both change what the law makes of a goal, so that no cut lies between them.
#pragma once

#include <string>

#include "gap/localize/block_test.hpp"

namespace darwinop::gap {

/// What changes in one place of the loop can explain.
struct Explained {
  double share = 0;       // of the cost beyond the noise
  Hypothesis hypothesis;  // the baseline with the changes
};

struct CommandSplit {
  Explained by_command, by_controller;
  double at_rest = 0;  // share of that cost while the goal has stood still for a while: a profile leaves none there
  [[nodiscard]] bool isCommand() const;
  [[nodiscard]] const Explained& best() const { return isCommand() ? by_command : by_controller; }
};

/// Tries each effect of the catalogue that delays or slows the goal, and each of the controller, at a few values, and
/// the best with one more.
CommandSplit splitCommand(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                          const BlockTest& judged, const Hypothesis& hypothesis);

/// By a delay of the goal alone; of a cut through the plant, where a delay below a row's time shows.
Explained explainByDelay(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                         const BlockTest& judged, const Hypothesis& hypothesis);

}  // namespace darwinop::gap
