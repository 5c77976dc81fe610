// Which curves of a log are shown, when nothing special is known about it or when columns were named.
#pragma once

#include <string>
#include <vector>

#include "experiments/logs/log.hpp"
#include "experiments/logs/plot/pieces.hpp"

namespace darwinop::plot {

/// The joints that the head of an experiment names; else those that move in any of these logs, the ones that move most
/// when there are many: a note names what is left out.
[[nodiscard]] std::vector<std::string> movingJoints(const std::vector<logs::Log>& all, std::vector<std::string>& notes);

/// Goal and measured position and load of these joints, gyro and accelerometer. `x` has a value a row.
[[nodiscard]] std::vector<Piece> usualPieces(const logs::Log& log, const std::vector<double>& x,
                                             const std::vector<std::string>& joints);

/// The columns that match one of the patterns ("*" any text, "?" one letter). Throws when one pattern matches none in
/// all logs, or when nobody could read so many curves.
void checkPatterns(const std::vector<logs::Log>& all, const std::vector<std::string>& patterns);
[[nodiscard]] std::vector<Piece> chosenPieces(const logs::Log& log, const std::vector<double>& x,
                                              const std::vector<std::string>& patterns);

}  // namespace darwinop::plot
