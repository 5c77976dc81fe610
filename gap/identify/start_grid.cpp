#include "gap/identify/start_grid.hpp"

#include <cmath>
#include <variant>

namespace darwinop::gap {
namespace {

double neutralOf(const Unknown& unknown) {
  const auto& parameter = std::get<EffectParameter>(unknown.what);
  return parameter.info->parameters[parameter.index].neutral;
}

std::vector<double> valuesOf(const Unknown& unknown, bool alone) {
  std::vector<double> values;
  if (unknown.logarithmic) {
    // Upwards from a thousandth of the range where small is weak; a delay, a play, a friction.
    const double low = std::max(unknown.low, unknown.high / 1'000), steps = alone ? 7 : 4;
    for (int i = 0; i < steps; ++i) values.push_back(low * std::pow(unknown.high / low, (i + 0.5) / steps));
    return values;
  }
  // On both sides of the neutral value; a limit of the duty has one side only.
  const double nothing = neutralOf(unknown), up = unknown.high - nothing, down = nothing - unknown.low;
  if (up > 0 && down > 0)
    for (const double share : {0.6, 0.15, 0.03})
      values.insert(values.end(), {nothing - share * down, nothing + share * up});
  else
    for (const double share : {0.03, 0.1, 0.2, 0.35, 0.55, 0.8}) values.push_back(nothing + share * (up - down));
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
