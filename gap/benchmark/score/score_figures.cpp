// The statistics of a score.
#include <algorithm>
#include <cmath>

#include "gap/benchmark/score/score.hpp"

namespace darwinop::gap {

std::pair<double, double> wilson(std::size_t right, std::size_t of) {
  if (of == 0) return {0, 1};
  constexpr double z = 1.959964;  // 97.5 % of a normal distribution lie below
  const double n = static_cast<double>(of), share = static_cast<double>(right) / n, square = z * z / n;
  const double middle = (share + square / 2) / (1 + square);
  const double half = std::sqrt(share * (1 - share) / n + square / (4 * n)) * z / (1 + square);
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

bool ShareFigure::reached() const {
  if (of == 0) return true;
  return !(share() < at_least) && !(share() > at_most);
}

bool isBelow(const Score& score, double fair_share) {
  return wilson(score.fair.right, score.fair.of).second < fair_share;
}

double SpreadFigure::quantile(double share) const {
  if (values.empty()) return std::nan("");
  std::vector<double> sorted = values;
  std::ranges::sort(sorted);
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

bool SpreadFigure::reached() const {
  return !(quantile(0.5) > median_at_most) && !(quantile(upper_quantile) > upper_at_most);
}

}  // namespace darwinop::gap
