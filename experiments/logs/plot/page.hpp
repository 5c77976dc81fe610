// The figure as one HTML page that needs nothing else: no network, no other file.
#pragma once

#include <string>

#include "experiments/logs/plot/figure.hpp"

namespace darwinop::plot {

[[nodiscard]] std::string htmlPage(const Figure& figure);

}  // namespace darwinop::plot
