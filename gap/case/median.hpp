// Median of what was measured.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace darwinop::gap {

/// NaN counts as not measured; NaN without a value. Of an even number, the greater of the two in the middle.
inline double medianOf(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace darwinop::gap
