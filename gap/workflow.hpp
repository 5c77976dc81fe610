// The whole of `darwinop gap run`, as a function.
#pragma once

#include <string>

#include "gap/identify/identification.hpp"
#include "gap/localize/localization.hpp"

namespace darwinop::gap {

/// Position error on logs that no fit has used, before and after, rad. NaN: the case has no such log.
struct Verification {
  double rms_before_rad = 0, rms_after_rad = 0;    // root mean square over all rows
  double mean_before_rad = 0, mean_after_rad = 0;  // mean |error| of each log, averaged
};

struct Outcome {
  Hypothesis baseline;
  Localization localization;
  Identification identification;
  Verification verification;
  std::string remainder;  // the remaining gap in sentences: where, when, on what it depends; empty: noise
  double runtime_s = 0;
};

/// check -> localize -> identify -> verify. gap/report makes text, JSON and HTML of the result. Deterministic for any
/// number of threads.
Outcome investigate(const Case& data, const IdentifyOptions& options = {});

}  // namespace darwinop::gap
