// When the goals of a row were written, in logs that only say that it was before the row was read.
#pragma once

#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// A number that every fit of such a case leaves free: time from the write of a goal to the read of its row, s.
struct WriteTime {
  static constexpr const char* kName = "written_before";
};

/// Longest time that is possible in every log, s: the shortest of their periods. 0: the case knows its instants.
double longestWriteTime(const Case& given);

/// Goals of this log are written at some time between two rows.
bool isWrittenBetween(const Case& given, const Trajectory& log, const Hypothesis& hypothesis);

/// When the goals of this row were written, s after row 0: never before the read of the row before.
double writtenAt(const Trajectory& log, std::size_t row, double written_before_s);

/// Share of a goal written at `written_s` in a firmware period that ends at `end_s`. The phase of the firmware is not
/// known: the mean over all of them, which is smooth in the time of the write.
double shareOfGoal(double end_s, double written_s, double period_s);

}  // namespace darwinop::gap
