// Run-to-run differences of repeated logs, as measured: no model has a part in them.
#pragma once

#include <cstddef>
#include <vector>

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Of positions, about the mean of all runs at each row.
struct RunSpread {
  double square_sum = 0;  // rad2
  double freedom = 0;     // degrees of freedom: rows that all runs have, times runs less one

  void add(const RunSpread& other) { square_sum += other.square_sum, freedom += other.freedom; }
  /// Standard deviation from run to run, rms over the rows, rad. NaN: nothing is repeated.
  [[nodiscard]] double rms_rad() const;
};

/// Positions of `run` at the rows of `first`, by time since the first row of each; NaN where it has none.
std::vector<double> alignedTo(const Trajectory& first, const Trajectory& run);

/// Rows are the same by time since the first one.
RunSpread spreadOf(const std::vector<const Trajectory*>& runs);

/// Logs of the case that repeat each other, the first of each series first; at least two in each group. `among`: only
/// these logs; empty: all. Copies of a file are not repeats.
std::vector<std::vector<std::size_t>> repeatGroups(const Case& c, const std::vector<std::size_t>& among = {});

/// Over all repeated logs of the case, fitted and held out.
RunSpread repeatSpread(const Case& c);

}  // namespace darwinop::gap
