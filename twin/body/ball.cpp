// Moves the ball on a circle in front of the robot, and reads DARWINOP_TWIN_BALL and DARWINOP_TWIN_BALL_COLOUR.
#include "twin/body/ball.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>

#include "twin/body/mujoco_model.hpp"
#include "twin/body/robot_body.hpp"

namespace darwinop::twin {
namespace {

// Assumed: visible to a kneeling robot, out of reach of its feet, 0.12 m/s.
constexpr double kCentre = 0.55, kRadius = 0.15;  // m, centre ahead of the start position
constexpr double kPeriod = 8;                     // s per turn

struct NamedColour {
  std::string_view name;
  BallColour colour;
};
// Orange as in twin/models/darwin-op.xml: the ball of the simulator's soccer world. Red: that of its visual tracking.
constexpr std::array kColours{NamedColour{"orange", {0.95F, 0.42F, 0.04F}}, NamedColour{"red", {0.85F, 0.1F, 0.08F}},
                              NamedColour{"yellow", {0.9F, 0.8F, 0.05F}}, NamedColour{"blue", {0.08F, 0.2F, 0.85F}}};

/// #RRGGBB.
std::optional<BallColour> fromHexDigits(std::string_view text) {
  std::uint32_t rgb = 0;
  if (text.size() != 7 || text.front() != '#') return std::nullopt;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), rgb, 16);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  const auto share = [rgb](unsigned shift) { return static_cast<float>(rgb >> shift & 255U) / 255; };
  return BallColour{share(16), share(8), share(0)};
}

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

void paintBall(mjModel_& model, const std::array<float, 3>& colour) noexcept {
  const int ball = mj_name2id(&model, mjOBJ_MATERIAL, "ball");
  if (ball >= 0) std::ranges::copy(colour, model.mat_rgba + std::ptrdiff_t{4} * ball);
}

std::optional<BallColour> ballColourFromEnvironment() {
  const char* const value = std::getenv("DARWINOP_TWIN_BALL_COLOUR");
  const std::string colour = value == nullptr ? "" : value;
  if (colour.empty()) return std::nullopt;
  const auto* const named = std::ranges::find(kColours, colour, &NamedColour::name);
  if (named != kColours.end()) return named->colour;
  if (const auto rgb = fromHexDigits(colour)) return rgb;
  throw std::runtime_error("DARWINOP_TWIN_BALL_COLOUR = " + colour + ": must be orange, red, yellow, blue or #RRGGBB");
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
