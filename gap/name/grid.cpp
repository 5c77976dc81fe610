#include "gap/name/grid.hpp"

#include <cmath>

namespace darwinop::gap {
namespace {

std::vector<double> valuesOf(const Unknown& unknown, bool alone) {
  std::vector<double> values;
  if (unknown.logarithmic) {
    // Upwards from a thousandth of the range where small is weak; a delay, a play, a friction.
    const double low = std::max(unknown.low, unknown.high / 1'000), steps = alone ? 7 : 4;
    for (int i = 0; i < steps; ++i) values.push_back(low * std::pow(unknown.high / low, (i + 0.5) / steps));
    return values;
  }
  const double middle = (unknown.low + unknown.high) / 2, half = (unknown.high - unknown.low) / 2;
  for (const double share : {-0.6, -0.15, -0.03, 0.03, 0.15, 0.6}) values.push_back(middle + share * half);
  return values;
}

}  // namespace

std::vector<std::vector<double>> gridOf(const std::vector<Unknown>& unknowns) {
  std::vector<std::vector<double>> grid{{}};
  for (const Unknown& unknown : unknowns) {
    std::vector<std::vector<double>> wider;
    for (const auto& point : grid)
      for (const double value : valuesOf(unknown, unknowns.size() == 1)) {
        wider.push_back(point);
        wider.back().push_back(value);
      }
    grid = std::move(wider);
  }
  return grid;
}

}  // namespace darwinop::gap
