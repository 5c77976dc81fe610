// A moving ball for tests of visual tracking: it circles in front of the robot.
#pragma once

struct mjData_;

namespace darwinop::twin {

struct BodyMap;

/// Sets position and velocity of the ball at `time_s` on its circle. Does nothing without a ball.
void moveBallOnCircle(mjData_& data, const BodyMap& map, double time_s) noexcept;

}  // namespace darwinop::twin
