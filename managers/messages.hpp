// Messages of the managers, or the parts that identify them.
#pragma once

namespace managers::messages {

inline constexpr const char* kRobotIsNull = "the robot is null";
inline constexpr const char* kWalksWithoutBalance =
    "balance is off: the gyroscope could not be calibrated, because the robot was moved or the gyroscope does not "
    "reply. Keep the robot still for a second before start()";

// After a damaged page of a motion file.
inline constexpr const char* kPageIsRefused = "; this page is refused, the others are kept";

}  // namespace managers::messages
