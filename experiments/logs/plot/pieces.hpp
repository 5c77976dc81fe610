// Curves of one log, and their grouping into panels.
#pragma once

#include <string>
#include <vector>

#include "experiments/logs/plot/figure.hpp"

namespace darwinop::plot {

/// One curve of one log. Curves of the same quantity are compared between logs.
struct LogCurve {
  std::string group;     // panel with one log: "gyro"
  std::string quantity;  // panel with several logs: "gyro.x"
  std::string name;      // curve label with one log: "x"
  std::string y_label;
  Curve curve;  // x, y, style, dashed
};

/// Panels in the order of their first curves. One log: one colour per quantity. Several logs: one panel per quantity,
/// one colour per log.
[[nodiscard]] std::vector<Panel> panelsOf(std::vector<std::vector<LogCurve>> curves_of_logs,
                                          const std::vector<Source>& sources);

}  // namespace darwinop::plot
