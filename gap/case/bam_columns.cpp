// Columns of BAM's logs that no fit needs, in a unit that is not theirs: they are left out, with a note, since the
// files have no names of columns that could say it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/case/bam_log.hpp"
#include "gap/case/column_bounds.hpp"
#include "gap/case/median.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

void drop(BamLog& from, std::vector<double> Trajectory::*column, const char* key, const std::string& why) {
  std::ranges::fill(from.log.*column, std::numeric_limits<double>::quiet_NaN());
  from.notes.push_back(from.log.file + ": " + key + why + messages::kColumnLeftOut);
}

/// Register over differenced position, over 20 ms or more: over less it is made of the encoder's steps.
void checkSpeed(BamLog& in) {
  constexpr double kWindow = 0.02;  // s
  constexpr double kOtherUnit = 4;  // rpm gives 9.5, degrees 57, counts of 0.114 rpm 84
  constexpr double kMoved = 0.2;    // rad/s: less is noise
  constexpr std::size_t kEnoughRows = 20;
  const Trajectory& log = in.log;
  std::vector<double> ratios;
  for (std::size_t from = 0, row = 1; row < log.rows(); ++row) {
    while (from + 1 < row && log.time_s[row] - log.time_s[from + 1] >= kWindow) ++from;
    const double time_s = log.time_s[row] - log.time_s[from];
    const double moved = std::abs(log.position_rad[row] - log.position_rad[from]) / time_s;
    if (time_s < kWindow || !(moved > kMoved) || std::isnan(log.speed_rad_s[row])) continue;
    ratios.push_back(std::abs(log.speed_rad_s[row]) / moved);
  }
  if (ratios.size() < kEnoughRows) return;
  const double ratio = medianOf(ratios);
  if (ratio > kOtherUnit || ratio < 1 / kOtherUnit)
    drop(in, &Trajectory::speed_rad_s, "speed", ratio == 0 ? messages::kZeroAsNotRead : messages::kOtherUnit);
}

/// Of these columns so many readings may be out of range as of others; with more the unit is another.
void checkRange(BamLog& log, const ColumnBounds& of, const char* key) {
  const std::vector<double>& values = log.log.*of.values;
  const auto read = values.size() - static_cast<std::size_t>(
                                        std::ranges::count_if(values, [](double value) { return std::isnan(value); }));
  const auto outside = static_cast<std::size_t>(
      std::ranges::count_if(values, [&](double value) { return value < of.low || value > of.high; }));
  if (areFew(outside, read)) return;
  const bool zero = std::ranges::all_of(values, [](double value) { return std::isnan(value) || value == 0; });
  drop(log, of.values, key, zero ? messages::kZeroAsNotRead : messages::kOtherUnit);
}

}  // namespace

void dropOddColumns(BamLog& log) {
  checkSpeed(log);
  checkRange(log, columnBounds()[kSpeed], "speed");
  checkRange(log, columnBounds()[kVolt], "input_volts");
  checkRange(log, columnBounds()[kTemp], "temp");
}

}  // namespace darwinop::gap
