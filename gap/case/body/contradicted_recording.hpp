// A recording that cannot be of this robot, held and placed as the case declares it: an effect that was fitted to it
// would be false.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/logs/log.hpp"
#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {
namespace messages {
inline constexpr const char* kGoalBeyondRange =
    " rad, beyond what the safety layer lets pass; correct the sign or the joint of the column where the recording is "
    "written";
inline constexpr const char* kOtherBattery = " V, and the board reads ";
inline constexpr const char* kLimpAtStart =
    " is limp in the first row and driven later; set `from_s` to a row in which all joints have held their goals for a "
    "second";
inline constexpr const char* kOtherRobotInHead = ": a case is of one robot";
}  // namespace messages

/// Throws BadInput, a sentence with file, column and what to do, for what is certain; a warning for what may be right.
void refuseContradicted(BodyCase& given, std::size_t log);

/// Heads of two recordings of one case. Throws BadInput where they are of two robots.
void refuseOtherRobot(const logs::Log& first, const logs::Log& other, std::vector<std::string>& warnings);

}  // namespace darwinop::gap
