// The ball in front of the robot: motion on a circle for tests of visual tracking, and colour.
#pragma once

#include <array>

struct mjData_;
struct mjModel_;

namespace darwinop::twin {

struct BodyMap;

/// Sets position and velocity of the ball at `time_s` on its circle. Does nothing without a ball.
void moveBallOnCircle(mjData_& data, const BodyMap& map, double time_s) noexcept;

/// Sets the colour of the material "ball". Does nothing without one.
void paintBall(mjModel_& model, const std::array<float, 3>& colour) noexcept;

}  // namespace darwinop::twin
