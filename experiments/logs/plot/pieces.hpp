// The curves that one log contributes, and how those of several logs come together in panels.
#pragma once

#include <string>
#include <vector>

#include "experiments/logs/plot/figure.hpp"

namespace darwinop::plot {

/// One curve of one log. Curves of the same quantity are what is compared between logs.
struct Piece {
  std::string group;     // the panel when there is one log: "gyro"
  std::string quantity;  // the panel when there are several: "gyro.x"
  std::string name;      // the curve when there is one log: "x"
  std::string y_label;
  Curve curve;  // x, y, style, dashed
};

/// Panels in the order in which their pieces come. One log: a colour a quantity. Several: a panel a quantity and a
/// colour a log.
[[nodiscard]] std::vector<Panel> panelsOf(std::vector<std::vector<Piece>> pieces_of_logs,
                                          const std::vector<Source>& sources);

}  // namespace darwinop::plot
