// Builds a figure from logs.
#pragma once

#include <vector>

#include "experiments/logs/log.hpp"
#include "experiments/logs/plot/figure.hpp"
#include "experiments/logs/plot/plot.hpp"

namespace darwinop::plot {

/// `all`: in the order of options.logs. Throws std::runtime_error if there is nothing to draw.
[[nodiscard]] Figure makeFigure(const std::vector<logs::Log>& all, const PlotOptions& options);

}  // namespace darwinop::plot
