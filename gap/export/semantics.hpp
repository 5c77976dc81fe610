// The gap of the exported joint, simulated by the target's own rules.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "gap/export/targets.hpp"

namespace darwinop::gap {

/// Of one log: rms of measured against simulated position.
struct LogGap {
  std::string file;
  bool held_out = false;
  double twin_mrad = 0, target_mrad = 0;
};

struct ReMeasured {
  Target target = Target::kWebots;
  double step_s = 0;
  std::vector<LogGap> logs;
  // Over all logs of a role; NaN: there are none.
  double twin_fit_mrad, target_fit_mrad, twin_held_out_mrad, target_held_out_mrad;
};

/// What an export of a case's model is usually made for: P and payload of its first log for fitting, mean temperature
/// of all of them.
ExportSettings settingsFor(const Case& given);

/// Simulates every log again. P register, payload and speed limit are each log's own, as a user would set them there;
/// temperature and time step are the settings'.
ReMeasured remeasure(Target target, const Case& given, const Hypothesis& hypothesis, const ExportSettings& settings);
ReMeasured remeasure(Target target, const Case& given, const Hypothesis& hypothesis);

/// A table for a terminal of 80 columns.
std::string asText(const ReMeasured& measured);

}  // namespace darwinop::gap
