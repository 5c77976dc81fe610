// Plausibility checks of logs: wrong units, stuck sensors and gaps in time must not become findings.
#pragma once

#include <string>

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Of one log, which errors call `file`. Throw BadInput with file, line and what to do; what is merely odd goes to the
/// warnings of the case. checkLog does all, and masks lone false readings.
void checkLog(Trajectory& log, const std::string& file, Case& of);
void checkRows(const Trajectory& log, const std::string& file);
void checkUnits(const Trajectory& log, const std::string& file, Case& c);
void checkSensor(const Trajectory& log, const std::string& file, const Case& c);

/// Of all logs: a declared repeat has the same commands; copies are reported.
void checkRepeats(Case& c);
/// For each log the earlier one that has the same goals and positions, row by row: one measurement, copied.
std::vector<std::optional<std::size_t>> duplicates(const Case& c);

/// Relative. Supply voltages measured on one bench differ by less, usual supplies (11.1, 12, 14.8 V) by more.
inline constexpr double kOneBench = 0.04;
/// Both repeat one motion on one bench, whether or not it is declared.
bool isRepeat(const Trajectory& a, const Trajectory& b);

/// Median time between rows.
double periodOf(const Trajectory& log);
/// In rad/s without load, by the model, at the supply of the case or of a log.
double noLoadSpeed(const Case& c);
double noLoadSpeed(const Case& c, const Trajectory& log);

/// A load that is 0 in every row although the control law asks for torque was not measured: it is NaN then, with a
/// warning.
void dropMissingLoad(Trajectory& log, const std::string& file, Case& of);
/// A load of another size than the control law asks for is in another unit, and counts as not measured, with a warning.
void dropOddLoad(Trajectory& log, const std::string& file, Case& of);
/// Throws BadInput for a load whose sign is the wrong way round.
void checkLoadSign(const Trajectory& log, const std::string& file, const Case& c);

}  // namespace darwinop::gap
