// Finds rows of a diagnosis.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "hal/cm730/diagnosis/finding.hpp"

namespace darwinop::cm730 {

inline bool has(const Findings& rows, Kind kind) {
  return std::ranges::any_of(rows, [kind](const Finding& row) { return row.is(kind); });
}

template <class Condition>
Finding theRow(const Findings& rows, Condition condition) {
  const auto found = std::ranges::find_if(rows, condition);
  if (found != rows.end()) return *found;
  ADD_FAILURE() << "no such row";
  return Finding::ok("");
}

/// The first row of this kind, or of this servo. There must be one.
inline Finding rowOf(const Findings& rows, Kind kind) {
  return theRow(rows, [kind](const Finding& row) { return row.is(kind); });
}
inline Finding rowOf(const Findings& rows, Joint joint) {
  return theRow(rows, [joint](const Finding& row) { return row.joint == joint; });
}

}  // namespace darwinop::cm730
