// Data check: quality of the logs, and which effects they can and cannot reveal. Nothing is fitted.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "gap/case/case.hpp"
#include "gap/case/contradictions.hpp"

namespace darwinop::gap {

/// From `low` to `high` of what was seen; NaN while nothing was.
struct Extent {
  double low, high;
  Extent();
  void add(double value);  // NaN is nothing
  void add(const Extent& other);
  [[nodiscard]] bool known() const;
  [[nodiscard]] double width() const;     // NaN when nothing was seen
  [[nodiscard]] double greatest() const;  // away from 0
};

/// What was done to the joint. Speeds are those of the positions over 70 ms.
struct Excitation {
  double duration_s = 0, powered_s = 0, limp_s = 0;
  double at_rest_s = 0;    // slower than a step of the encoder resolves
  double slow_s = 0;       // moving, where friction depends on speed: up to 0.3 rad/s
  double saturated_s = 0;  // load at its greatest
  int reversals = 0;       // of the motion
  int load_reversals = 0;  // of the load, from beyond 2 % to beyond -2 %
  Extent position_rad, speed_rad_s, load, volt_v, temp_c;
  Extent session_s;  // clock of the session
  std::set<double> payloads_kg, p_registers;

  void add(const Excitation& other);
};

/// Of one log.
struct LogCheck {
  std::string file, kind;
  bool held_out = false;
  std::optional<std::size_t> duplicate_of;
  std::size_t rows = 0, lost_rows = 0;  // lost: holes in time, in periods
  double period_s = 0;                  // median
  double late_s = 0;                    // 99 % of the rows come at most so much later than a period
  Excitation excitation;
};

/// Whether the held-out logs load the joint as much as the fitted ones.
inline constexpr std::string_view kHeldOutLoadFinding = "held_out_load";

/// Something that these data show, or do not.
struct DataFinding {
  std::string_view id;                    // "no_torque_off"
  bool reveals = false;                   // true: they can
  std::string sentence;                   // for the user
  std::vector<std::string_view> effects;  // that cannot be distinguished, or not be seen; ids of the catalogue
  std::string_view remedy;                // what to measure; empty when it reveals
  std::optional<twin::LogFeature> feature = std::nullopt;  // that effects are observable by
};

struct DataCheck {
  std::vector<LogCheck> logs;
  Excitation fit;       // all logs that are fitted, copies once
  Excitation held_out;  // all held-out logs
  bool has_repeats = false;
  double repeats_rad = 0;             // standard deviation of positions over all repeats; NaN: none
  std::vector<DataFinding> findings;  // what cannot be seen first
  std::vector<Contradiction> contradictions;
  std::vector<std::string> masked;  // sentences on readings that count nowhere, by log and column
  std::vector<std::string> warnings;
};

DataCheck checkData(const Case& c);

/// A table and sentences for a terminal of 80 columns or more.
std::string asText(const DataCheck& check);

}  // namespace darwinop::gap
