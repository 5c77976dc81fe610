// A ball for eyes to follow: led round in a circle in front of the robot, as somebody with a stick would.
#pragma once

struct mjData_;

namespace darwinop::twin {

struct BodyMap;

/// Puts the ball where it is at this time, and gives it the speed that it has there. Nothing where there is no ball.
void leadBall(mjData_& data, const BodyMap& map, double time_s) noexcept;

}  // namespace darwinop::twin
