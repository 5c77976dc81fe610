// Data check of a case of the whole robot: what is there, what is odd, and what these logs cannot show. Nothing is
// fitted.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

struct BodyLogCheck {
  double duration_s = 0, period_s = 0;    // median period
  std::size_t late_rows = 0;              // more than half a period late: holes in time
  double limp_s = 0;                      // of the joint that is limp for longest
  std::vector<std::string_view> limp;     // joints that are limp in some row
  std::vector<std::string> no_reading;    // columns of the inertial sensor that are empty
  std::vector<std::string_view> unmoved;  // joints whose position never changes by more than some ticks
  std::size_t unanswered = 0;             // positions that are not known, of all joints
  double greatest_rate_rad_s = 0;         // of the gyroscope's axes about their median
};

struct BodyCheck {
  std::vector<BodyLogCheck> logs;        // as those of the case
  std::size_t orientations = 0;          // independent directions of gravity, read in clamped logs that are fitted
  std::vector<std::string> cannot_show;  // sentences with what to record
  std::vector<std::string> warnings;
};

BodyCheck checkData(const BodyCase& given);

/// Of columns without a reading, what to do. Empty: every one has some.
std::string noReadingText(const BodyLogCheck& check);

/// For a terminal of 100 columns.
std::string asText(const BodyCase& given, const BodyCheck& check);

}  // namespace darwinop::gap
