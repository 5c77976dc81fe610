#include "gap/plant/write_instant.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/case/plausible.hpp"

namespace darwinop::gap {

double longestWriteTime(const Case& given) {
  if (given.goal_order != GoalOrder::kBeforeRead || given.written_before_s) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const Trajectory& log : given.logs)
    if (log.rows() > 1) least = std::min(least, periodOf(log));
  return least < std::numeric_limits<double>::infinity() ? least : 0;
}

bool isWrittenBetween(const Case& given, const Trajectory& log, const Hypothesis& hypothesis) {
  return given.goal_order == GoalOrder::kBeforeRead && !log.isReadAfterWrite() &&
         std::isfinite(hypothesis.written_before_s);
}

double writtenAt(const Trajectory& log, std::size_t row, double written_before_s) {
  if (row == 0) return 0;
  return std::max(log.time_s[row - 1], log.time_s[row] - written_before_s) - log.time_s[0];
}

double shareOfGoal(double end_s, double written_s, double period_s) {
  constexpr double kSameInstant = 1e-6;  // of a period; times in a log are rounded decimals
  const double share = (end_s - written_s) / period_s;
  return share > 1 - kSameInstant ? 1 : std::max(0.0, share);
}

}  // namespace darwinop::gap
