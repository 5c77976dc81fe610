// Recordings of an earlier `darwinop gap record`, which --resume keeps.
#pragma once

#include <string>

#include "experiments/logs/log.hpp"
#include "gap/record/recordings.hpp"

namespace darwinop::gap {

inline constexpr const char* kTwinInHead = "twin in memory";  // begins connect::twinInHead()

namespace messages {
inline constexpr const char* kClockSetBack =
    "the clock of this computer was set back since the recordings in this folder; set it right, or give another folder "
    "with --out";
inline constexpr const char* kAnotherSession =
    " min ago: recorded in another session; battery and temperature of the servos differ";
inline constexpr const char* kOfAnotherRobot = "it is of another robot: ";  // then its "model"
inline constexpr const char* kEarlierOnesAreOf = "; the earlier ones are of ";
}  // namespace messages

/// When it began, s since 1970 by the computer's clock, to 1 s. Throws BadInput unless `recording` is one of the
/// planned experiment, complete, on this robot. `twin`: its "model" in the head; empty: a physical robot.
double beginOf(const logs::Log& recording, const PlannedRecording& plan, const std::string& twin);

/// "model" in the head: which robot it is of.
std::string robotOf(const logs::Log& recording);
/// `robot`: as above. `twin`: as for beginOf(). Of two physical robots false: a port may have another name tomorrow.
bool isOtherRobot(const std::string& robot, const std::string& twin);
/// s since 1970 by the computer's clock, to 1 s. Throws BadInput if its head has none.
double dateIn(const logs::Log& recording);

/// Age of a session whose first and last recordings began then; all in s since 1970. Throws BadInput if the clock was
/// set back since.
double sessionAge(double first_s, double last_s, double now_s);

/// What to know before recordings are added to earlier ones of which the last began this long ago; empty: nothing.
std::string pauseText(double pause_s);

}  // namespace darwinop::gap
