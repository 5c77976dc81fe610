// The common step of a column of positions: the resolution of what was logged, in the column's own unit.
#pragma once

#include <optional>
#include <vector>

namespace darwinop::gap {

/// The share of `values` that are a whole number of steps from the first.
double shareOnGrid(const std::vector<double>& values, double step);

/// The greatest step of which nearly all differences between `values` are multiples. Nothing: there are fewer than ten
/// different values, no common step, or it is the last decimal of the file.
std::optional<double> commonStep(const std::vector<double>& values);

}  // namespace darwinop::gap
