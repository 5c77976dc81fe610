// Phrases that identify errors in experiment files, and what a plan says about falling.
#pragma once

namespace darwinop::experiments::messages {

// errors
inline constexpr const char* kAddMoveBefore = "add a phase with goal = move before it";
inline constexpr const char* kNameLetters = "use lower-case letters, digits, _ and -";
inline constexpr const char* kOwnExperiment = "; name your own file by its path: ./";  // then the file
inline constexpr const char* kNeitherSectionNorPair = "is neither a section nor key = value";
inline constexpr const char* kPhaseNeedsName = "a phase needs a name";
inline constexpr const char* kSweepUnused = "no phase uses these values";

// whether the robot falls
inline constexpr const char* kClamped = "no: its trunk is clamped in a stand, and all limbs are free in the air";
inline constexpr const char* kFalls = "YES: the robot falls at the end. Use a soft floor and catch it";
inline constexpr const char* kFallsInList = ", falls at the end";
inline constexpr const char* kLegsMayMove =
    "possibly: the legs move or their torque is off. Hold the robot by its handle";
inline constexpr const char* kOnFeet = "possibly: the robot stands on its feet. Hold it by its handle";
inline constexpr const char* kOnKnees = "no: the robot stays on its knees";

}  // namespace darwinop::experiments::messages
