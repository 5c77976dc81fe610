// The plot that belongs to an experiment: what its authors drew, such as time per sweep over speed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/logs/log.hpp"
#include "experiments/logs/plot/pieces.hpp"

namespace darwinop::plot {

struct NaturalPlot {
  std::string_view word;  // the experiment's name contains it: "speed"
  std::string_view title, x_label;
  /// Nothing: the log does not show what the plot needs.
  std::vector<Piece> (*pieces)(const logs::Log& log);
};

/// The plot of the experiment that the head names, or null.
[[nodiscard]] const NaturalPlot* naturalPlot(const logs::Log& log);

}  // namespace darwinop::plot
