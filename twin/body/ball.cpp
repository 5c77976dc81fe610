// Moves the ball on a circle in front of the robot, and reads DARWINOP_TWIN_BALL.
#include "twin/body/ball.hpp"

#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>
#include <string>

#include "twin/body/mujoco_model.hpp"
#include "twin/body/robot_body.hpp"

namespace darwinop::twin {
namespace {

// Assumed: visible to a kneeling robot, out of reach of its feet, 0.12 m/s.
constexpr double kCentre = 0.55, kRadius = 0.15;  // m, centre ahead of the start position
constexpr double kPeriod = 8;                     // s per turn

}  // namespace

void moveBallOnCircle(mjData_& data, const BodyMap& map, double time_s) noexcept {
  if (map.ball_qpos < 0) return;
  const double speed = 2 * std::numbers::pi / kPeriod, angle = speed * time_s;
  mjtNum* const place = data.qpos + map.ball_qpos;
  mjtNum* const velocity = data.qvel + map.ball_dof;
  place[0] = kCentre + kRadius * std::cos(angle);
  place[1] = kRadius * std::sin(angle);
  mju_zero(velocity, 6);
  velocity[0] = -kRadius * speed * std::sin(angle);
  velocity[1] = kRadius * speed * std::cos(angle);
}

Ball ballFromEnvironment() {
  const char* const value = std::getenv("DARWINOP_TWIN_BALL");
  const std::string ball = value == nullptr ? "" : value;
  if (ball.empty() || ball == "rests") return Ball::kRests;
  if (ball == "none") return Ball::kNone;
  if (ball == "circles") return Ball::kCircles;
  throw std::runtime_error("DARWINOP_TWIN_BALL = " + ball + ": must be none, rests or circles");
}

}  // namespace darwinop::twin
