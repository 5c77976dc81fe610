// Message texts, or the parts that identify them.
#pragma once

namespace darwinop::calibrate::messages {

// Followed by names of joints.
inline constexpr const char* kNotObserved = "Not found well enough, left as before: ";
inline constexpr const char* kByHand =
    ".\nHold them at zero by hand: darwinop calibrate by-hand NAME... (docs/calibrate.md).\n";

// After the name of a posture.
inline constexpr const char* kSweepBegins = ": the sweep begins";

inline constexpr const char* kNothingSwept = "no posture was held, so nothing was measured";

}  // namespace darwinop::calibrate::messages
