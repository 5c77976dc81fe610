#include "gap/case/rest_angle.hpp"

#include <algorithm>
#include <cmath>

#include "core/sensors.hpp"
#include "core/units.hpp"
#include "gap/case/median.hpp"

namespace darwinop::gap {
namespace {

constexpr double kStillTime = 0.2;     // s, before the release and at the end
constexpr double kStillSpread = 0.02;  // rad: some steps of an encoder
constexpr double kFall = 0.1;          // rad: more than backlash and what gives way in a mount

/// Angle of the rows from `from` to `to`; NaN: they are not still.
double stillAngle(const Trajectory& log, std::size_t from, std::size_t to) {
  double low = kUnknown, high = kUnknown;
  for (std::size_t row = from; row < to; ++row) {
    low = std::fmin(low, log.position_rad[row]);
    high = std::fmax(high, log.position_rad[row]);
  }
  return high - low < kStillSpread ? (low + high) / 2 : kUnknown;
}

std::size_t beginOfStill(const Trajectory& log, std::size_t end) {
  std::size_t row = end;
  while (row > 0 && log.time_s[end - 1] - log.time_s[row - 1] <= kStillTime) --row;
  return row;
}

}  // namespace

double restBeyondRelease(const Trajectory& log) {
  std::vector<double> rests;
  for (std::size_t from = 0, to = 0; from < log.rows(); from = std::max(to, from + 1)) {
    for (to = from; to < log.rows() && log.torque_on[to] == 0;) ++to;
    if (from == 0 || to == from) continue;
    const double released = stillAngle(log, beginOfStill(log, from), from);
    const double rest = stillAngle(log, std::max(from, beginOfStill(log, to)), to);
    const double hanging = std::remainder(rest, 2 * kPi);
    if (std::abs(rest - released) > kFall && std::abs(hanging) > std::abs(std::remainder(released, 2 * kPi)) + kFall)
      rests.push_back(hanging);
  }
  return medianOf(std::move(rests));
}

}  // namespace darwinop::gap
