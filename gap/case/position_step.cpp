#include "gap/case/position_step.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace darwinop::gap {
namespace {

constexpr double kOnGrid = 0.2;             // of a step; two values rounded to 0.1 mrad are 0.15 of 0.65 mrad apart
constexpr double kGridShare = 0.99;         // of the rows
constexpr std::size_t kGridValues = 10;     // different positions that it takes to see a grid
constexpr double kOneStep = 1.5;            // times the smallest difference: up to here it is one step, rounded
constexpr double kDecimalTolerance = 0.01;  // of a step: 0.00100 is the last decimal of a file, 0.00098 is not

/// The mean of single steps first; then a walk through all values, where rounding counts once in the whole width.
double stepOf(const std::set<double>& values) {
  std::vector<double> differences;
  for (auto next = std::next(values.begin()); next != values.end(); ++next)
    differences.push_back(*next - *std::prev(next));
  const double least = *std::ranges::min_element(differences);
  double sum = 0, count = 0;
  for (const double difference : differences)
    if (difference < kOneStep * least) sum += difference, ++count;
  double step = sum / count, steps = 0;
  for (const double value : values) {
    const double width = value - *values.begin();
    steps += std::nearbyint((width - steps * step) / step);
    if (steps * steps > count) step = width / steps;  // by now closer than the mean
  }
  return step;
}

bool isDecimal(double step) {
  const double decimals = std::log10(step);
  return std::abs(std::pow(10, std::nearbyint(decimals)) / step - 1) < kDecimalTolerance;
}

}  // namespace

double shareOnGrid(const std::vector<double>& values, double step) {
  std::size_t on = 0;
  for (const double value : values) {
    const double steps = (value - values.front()) / step;
    if (std::abs(steps - std::nearbyint(steps)) <= kOnGrid) ++on;
  }
  return double(on) / double(values.size());
}

std::optional<double> commonStep(const std::vector<double>& values) {
  const std::set<double> different{values.begin(), values.end()};
  if (different.size() < kGridValues) return std::nullopt;
  const double step = stepOf(different);
  if (isDecimal(step) || shareOnGrid(values, step) < kGridShare) return std::nullopt;
  return step;
}

}  // namespace darwinop::gap
