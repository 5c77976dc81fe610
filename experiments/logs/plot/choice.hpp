// Selects the curves of a log: by default, or by column patterns.
#pragma once

#include <string>
#include <vector>

#include "experiments/logs/log.hpp"
#include "experiments/logs/plot/pieces.hpp"

namespace darwinop::plot {

/// The joints named in the header of an experiment; otherwise the joints that move in any log, limited to those that
/// move most (a note lists the others).
[[nodiscard]] std::vector<std::string> movingJoints(const std::vector<logs::Log>& all, std::vector<std::string>& notes);

/// Goal, measured position and load of these joints, gyro and accelerometer. `x`: one value per row.
[[nodiscard]] std::vector<LogCurve> defaultCurves(const logs::Log& log, const std::vector<double>& x,
                                                  const std::vector<std::string>& joints);

/// Columns that match one of the patterns ("*" any text, "?" one character). Both throw std::runtime_error: for a
/// pattern without a match in any log, and for too many curves.
void checkPatterns(const std::vector<logs::Log>& all, const std::vector<std::string>& patterns);
[[nodiscard]] std::vector<LogCurve> selectedCurves(const logs::Log& log, const std::vector<double>& x,
                                                   const std::vector<std::string>& patterns);

}  // namespace darwinop::plot
