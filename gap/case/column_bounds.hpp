// The columns of a log whose readings may be masked, their physical ranges, and how many may be missing.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// A unit that the whole column may be in instead.
struct OtherUnit {
  double factor;  // to the unit in the name of the column
  std::string_view advice;
};
struct ColumnBounds {
  std::vector<double> Trajectory::*values;
  std::string_view column, unit;
  double low, high, shown;  // shown: factor to what the file has
  std::array<OtherUnit, 2> others;
};

std::span<const ColumnBounds> columnBounds();
inline constexpr std::size_t kPos = 0, kSpeed = 1, kLoad = 2, kVolt = 3, kTemp = 4;  // in columnBounds()

/// At most kMostMasked.
bool areFew(std::size_t some, std::size_t all);

/// Rows without a reading are left out: nothing is masked there.
void mask(Trajectory& log, const ColumnBounds& of, std::vector<std::size_t> rows, std::string_view why);

/// Throw BadInput, which calls the log `file`, where readings are not few.
void noteEmptyPositions(Trajectory& log, const std::string& file);
void maskOutOfRange(Trajectory& log, const std::string& file, const ColumnBounds& of);
/// Each check may mask few, and all of them together too many. Positions must be there; other columns may be sparse.
void refuseManyMasked(const Trajectory& log, const std::string& file);

}  // namespace darwinop::gap
