#include "gap/case/log_traits.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::gap {
namespace {

double octave(double value) {
  return value > 0 ? std::floor(std::log2(value)) : -1e3;
}

}  // namespace

int LogTraits::sameAs(const LogTraits& other) const {
  int same = motion == other.motion ? 3 : 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) same += numbers[i] == other.numbers[i] ? 1 : 0;
  return same;
}

LogTraits traitsOf(const Trajectory& log) {
  double fastest = 0;
  for (std::size_t row = 1; row < log.rows(); ++row)
    fastest = std::max(fastest, std::abs(log.goal_rad[row] - log.goal_rad[row - 1]) /
                                    std::max(1e-6, log.time_s[row] - log.time_s[row - 1]));
  const auto [low, high] = std::ranges::minmax(log.goal_rad);
  const bool released = std::ranges::find(log.torque_on, 0) != log.torque_on.end();
  return {log.kind,
          {log.p_register, log.payload_kg, log.length_m.value_or(0), log.arm_mass_kg.value_or(0),
           log.supply_v.value_or(0), released ? 1.0 : 0.0, octave(fastest), octave(high - low)}};
}

int likeness(const LogTraits& one, const std::vector<LogTraits>& chosen) {
  int sum = 0;
  for (const LogTraits& other : chosen) sum += one.sameAs(other) * one.sameAs(other);
  return sum;
}

}  // namespace darwinop::gap
