// Numbers of the program that the page uses as well. tests/window/page_limits_test.cpp compares them with the program's.

export const kGravity = 9.80665;        // m/s2
export const kServoHot = 65;            // deg C: the robot slows down (fault 22)
export const kStartTolerance = 0.3528;  // rad from the start pose
export const kOrientationTolerance = kGravity / 4;  // m/s2 on each axis
