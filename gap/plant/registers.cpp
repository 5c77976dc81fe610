#include "gap/plant/registers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "core/conversions.hpp"
#include "gap/plant/trace.hpp"

namespace darwinop::gap {

double loadStepOf(const Trajectory& log) {
  constexpr std::size_t kFewest = 10;  // different values: fewer have a common step by chance
  constexpr double kOffGrid = 0.01;    // of a step: decimals are rounded
  std::set<double> values;
  for (const double load : log.load)
    if (!std::isnan(load)) values.insert(load);
  if (values.size() < kFewest) return kLoadStep;
  double step = std::numeric_limits<double>::infinity();
  for (auto value = std::next(values.begin()); value != values.end(); ++value)
    step = std::min(step, *value - *std::prev(value));
  const bool on_grid = std::ranges::all_of(
      values, [&](double value) { return std::abs(value / step - std::round(value / step)) < kOffGrid; });
  return on_grid ? std::max(step, kLoadStep) : kLoadStep;
}

double readingSigma(const twin::ServoParameters& servo) {
  return 2 * kPi / servo.ticks_per_rev * std::hypot(kRoundingSigma, Disturbance{}.encoder_ticks);
}

}  // namespace darwinop::gap
