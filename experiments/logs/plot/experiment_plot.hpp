// Plot specific to an experiment, as in the thesis, such as time per sweep over speed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/logs/log.hpp"
#include "experiments/logs/plot/pieces.hpp"

namespace darwinop::plot {

struct ExperimentPlot {
  std::string_view word;  // a word of the experiment's name, which may have others: "speed"
  std::string_view title, x_label;
  /// Empty if the log lacks the data.
  std::vector<LogCurve> (*curves)(const logs::Log& log);
};

/// The plot of the experiment named in the header, or null.
[[nodiscard]] const ExperimentPlot* experimentPlot(const logs::Log& log);

}  // namespace darwinop::plot
