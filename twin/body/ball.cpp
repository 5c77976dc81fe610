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

// Assumed: near enough to be seen by a kneeling robot and far enough for its feet, as fast as a child rolls a ball.
constexpr double kMiddle = 0.55, kRadius = 0.15;  // m, ahead of the start
constexpr double kTurn = 8;                       // s a turn

}  // namespace

void leadBall(mjData_& data, const BodyMap& map, double time_s) noexcept {
  if (map.ball_qpos < 0) return;
  const double speed = 2 * std::numbers::pi / kTurn, angle = speed * time_s;
  mjtNum* const place = data.qpos + map.ball_qpos;
  mjtNum* const velocity = data.qvel + map.ball_dof;
  place[0] = kMiddle + kRadius * std::cos(angle);
  place[1] = kRadius * std::sin(angle);
  mju_zero(velocity, 6);
  velocity[0] = -kRadius * speed * std::sin(angle);
  velocity[1] = kRadius * speed * std::cos(angle);
}

Ball ballFromEnvironment() {
  const char* const said = std::getenv("DARWINOP_TWIN_BALL");
  const std::string ball = said == nullptr ? "" : said;
  if (ball.empty() || ball == "rests") return Ball::kRests;
  if (ball == "none") return Ball::kNone;
  if (ball == "circles") return Ball::kCircles;
  throw std::runtime_error("DARWINOP_TWIN_BALL = " + ball + ": it can be none, rests or circles");
}

}  // namespace darwinop::twin
