// Numbers of the model that a column of the logs contradicts, before anything is fitted. A fit would move other numbers
// instead: a supply that is too high ends in the resistance.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// A released arm falls away from where the case says that it hangs: its zero is elsewhere.
inline constexpr std::string_view kRestAngle = "angle at which the released arm hangs";

struct Contradiction {
  std::string_view number, unit;   // as in case.json: "supply_V"
  double model = 0, measured = 0;  // measured: mean of the medians of the logs
  std::size_t logs = 0, of = 0;    // logs that contradict, of those that measure it
};

/// Median voltage of a log without current; NaN where it does not show it.
double idleVoltage(const Trajectory& log);

/// One entry for each value that the case or its logs give.
std::vector<Contradiction> contradictionsOf(const Case& c);

/// "supply_V is 15 V in the model and 12.0 V in 12 of 12 logs; correct it before anything is fitted"
std::string asSentence(const Contradiction& found);

}  // namespace darwinop::gap
