// Logs that repeat another one, and logs that are another one.
#include <algorithm>
#include <cmath>

#include "gap/case/messages.hpp"
#include "gap/case/plausible.hpp"

namespace darwinop::gap {
namespace {

constexpr double kSameGoals = 0.1;    // rms of the difference over that of the goals; clocks differ by a row
constexpr double kSameRelease = 0.1;  // share of the rows; ends of logs differ

/// Rms of a - b where both run, row by row of a, by time since the first row; over the rms of a about its mean.
double goalsApart(const Trajectory& a, const Trajectory& b) {
  double sum = 0, mean = 0, square = 0, n = 0;
  std::size_t j = 0;
  for (std::size_t i = 0; i < a.rows(); ++i) {
    const double t = a.time_s[i] - a.time_s.front() + b.time_s.front();
    while (j + 1 < b.rows() && std::abs(b.time_s[j + 1] - t) <= std::abs(b.time_s[j] - t)) ++j;
    const double apart = a.goal_rad[i] - b.goal_rad[j];
    sum += apart * apart, mean += a.goal_rad[i], square += a.goal_rad[i] * a.goal_rad[i], n += 1;
  }
  const double spread = square / n - mean * mean / (n * n);
  return std::sqrt(sum / n / std::max(spread, 1e-6));
}

/// Masked ones are equal.
bool samePositions(const Trajectory& a, const Trajectory& b) {
  return std::ranges::equal(a.position_rad, b.position_rad,
                            [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

bool isCopy(const Trajectory& a, const Trajectory& b) {
  if (!samePositions(a, b) || a.goal_rad != b.goal_rad) return false;
  // A joint that stands still looks the same each time.
  const auto moves = [](double before, double after) { return before < after || before > after; };
  return std::ranges::adjacent_find(a.position_rad, moves) != a.position_rad.end();
}

bool haveOneArm(const Trajectory& a, const Trajectory& b) {
  return a.payload_kg == b.payload_kg && a.length_m == b.length_m && a.arm_mass_kg == b.arm_mass_kg;
}

bool haveOneSupply(const Trajectory& a, const Trajectory& b) {
  if (!a.supply_v || !b.supply_v) return a.supply_v.has_value() == b.supply_v.has_value();
  return std::abs(*a.supply_v / *b.supply_v - 1) <= kOneBench;
}

/// Share of the rows without torque.
double released(const Trajectory& log) {
  return static_cast<double>(std::ranges::count(log.torque_on, 0)) / static_cast<double>(log.rows());
}

}  // namespace

bool isRepeat(const Trajectory& a, const Trajectory& b) {
  return a.p_register == b.p_register && haveOneArm(a, b) && haveOneSupply(a, b) &&
         std::abs(released(a) - released(b)) <= kSameRelease && goalsApart(a, b) <= kSameGoals;
}

std::vector<std::optional<std::size_t>> duplicates(const Case& c) {
  std::vector<std::optional<std::size_t>> of(c.logs.size());
  for (std::size_t i = 0; i < c.logs.size(); ++i)
    for (std::size_t j = 0; j < i && !of[i]; ++j)
      if (!of[j] && isCopy(c.logs[i], c.logs[j])) of[i] = j;
  return of;
}

void checkRepeats(Case& c) {
  const std::string file = c.folder + "/case.json";
  for (std::size_t i = 0; i < c.logs.size(); ++i) {
    const Trajectory& log = c.logs[i];
    if (!log.repeat_of) continue;
    const Trajectory& first = c.logs[*log.repeat_of];
    const std::string place = file + ": `logs[" + std::to_string(i) + "].repeat_of` ";
    if (log.p_register != first.p_register || !haveOneArm(log, first) || log.supply_v != first.supply_v)
      throw BadInput(place + "names " + first.file + ", " + messages::kOtherGainOrPayload + "; a repeat has the same");
    if (goalsApart(log, first) > kSameGoals)
      throw BadInput(place + "names " + first.file + ", which has other goals; a repeat has the same");
  }
  const auto copies = duplicates(c);
  for (std::size_t i = 0; i < copies.size(); ++i)
    if (copies[i])
      c.warnings.push_back(c.folder + "/" + c.logs[i].file + ": has the same rows as " + c.logs[*copies[i]].file +
                           "; a copy counts once and not as a repeat");
}

}  // namespace darwinop::gap
