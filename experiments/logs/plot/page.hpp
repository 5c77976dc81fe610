// The figure as one self-contained HTML file.
#pragma once

#include <string>

#include "experiments/logs/plot/figure.hpp"

namespace darwinop::plot {

[[nodiscard]] std::string htmlPage(const Figure& figure);

}  // namespace darwinop::plot
