// What distinguishes one log from another. Names of files do not count; what was set, the motion that a log names and
// what its goals do, does.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "gap/case/case.hpp"

namespace darwinop::gap {

struct LogTraits {
  std::string_view motion;        // the log's `kind`
  std::array<double, 8> numbers;  // gain, payload and bench; released or not; speed and travel of the goals, in octaves

  bool operator==(const LogTraits&) const = default;
  /// How many are the same. The motion counts as three: motions of several names share release, speed and travel.
  [[nodiscard]] int sameAs(const LogTraits& other) const;
};
/// `log` must outlive them.
LogTraits traitsOf(const Trajectory& log);

/// Likeness to those that are chosen. Squares: one log that is nearly the same counts more than several that share a
/// trait each.
int likeness(const LogTraits& one, const std::vector<LogTraits>& chosen);

}  // namespace darwinop::gap
