// From logs to a figure.
#pragma once

#include <vector>

#include "experiments/logs/log.hpp"
#include "experiments/logs/plot/figure.hpp"
#include "experiments/logs/plot/plot.hpp"

namespace darwinop::plot {

/// `all` is in the order of options.logs. Throws std::runtime_error when there is nothing to draw.
[[nodiscard]] Figure makeFigure(const std::vector<logs::Log>& all, const PlotOptions& options);

}  // namespace darwinop::plot
