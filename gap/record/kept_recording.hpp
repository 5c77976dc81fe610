// Recordings of an earlier `darwinop gap record`, which --resume keeps.
#pragma once

#include <string>

#include "experiments/logs/log.hpp"
#include "gap/record/recordings.hpp"

namespace darwinop::gap {

inline constexpr const char* kTwinInHead = "twin in memory";  // begins "model" in the head of a recording: connect.cpp

/// When it began, s since 1970 by the computer's clock, to 1 s. Throws BadInput unless `recording` is one of the
/// planned experiment, complete, on a robot of this kind.
double beginOf(const logs::Log& recording, const PlannedRecording& plan, RecordedRobot robot);

}  // namespace darwinop::gap
