// Dependence of the gap on the state of the joint, or on the time of the session.
#pragma once

#include <string>
#include <vector>

#include "gap/localize/blocks.hpp"
#include "gap/localize/residual.hpp"

namespace darwinop::gap {

inline constexpr const char* kSessionTime = "session time";  // a Region::variable

/// One variable of the state, cut into bins.
struct Region {
  std::string variable;      // "position", "load", kSessionTime
  std::string unit;          // "rad"; empty: a pure number
  double information = 0;    // mutual information with the residual, bits, minus its chance level
  double low = 0, high = 0;  // the bin with most energy
  double lift = 1;           // energy there over the mean
};

enum class Depends : std::uint8_t { kNothing, kState, kClock, kBoth };
std::string_view name(Depends depends);

struct Dependence {
  std::string of;               // "position" or a block: whose residuals were analysed
  std::vector<Region> regions;  // greatest information first
  Depends on = Depends::kNothing;
  bool is_clock_known = true;         // of the session, in every log
  double by_state = 0, by_clock = 0;  // shares of the variance: by the state; by the session time at the same state
};

/// The residuals of the first open block, or of the positions when none is.
Dependence dependenceOf(const Case& given, const std::vector<LogResidual>& residuals, const Blocks& blocks);

}  // namespace darwinop::gap
