// Simulated robot: 20 servo models on a MuJoCo body.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "hal/body.hpp"
#include "twin/body/clamp.hpp"
#include "twin/model/model.hpp"

struct mjModel_;
struct mjData_;

namespace darwinop::twin {

/// Ball in front of the robot: none, at rest, or moved on a circle.
enum class Ball { kNone, kRests, kCircles };

/// Red, green, blue, 0 to 1, before lighting.
using BallColour = std::array<float, 3>;

struct RobotBodyOptions {
  std::uint64_t seed = 1;  // of noise; runs with the same seed are identical
  Ball ball = Ball::kRests;
  std::optional<BallColour> ball_colour = {};  // empty: that of the body file
  std::optional<ClampedUp> clamped_up = {};    // the trunk is held in a stand; empty: it is free
};

/// DARWINOP_TWIN_BALL: none, rests (default), circles. Throws std::runtime_error for any other value.
Ball ballFromEnvironment();

/// DARWINOP_TWIN_BALL_COLOUR: orange, red, yellow, blue or #RRGGBB. Empty if it is not set. Throws std::runtime_error
/// for any other value.
std::optional<BallColour> ballColourFromEnvironment();

/// Begins in the start pose, kneeling on the floor or in the stand, at rest. The constructor throws std::runtime_error
/// if MuJoCo cannot load the body. Not thread-safe; step() allocates nothing.
class RobotBody final : public Body {
 public:
  explicit RobotBody(const Model& model, const RobotBodyOptions& options = {});
  ~RobotBody() override;

  /// Simulates `dt` in steps of the model; a remainder is carried over to the next call.
  void step(Nanos dt, const Drives& drives) noexcept override;
  [[nodiscard]] const BodyState& state() const noexcept override;
  [[nodiscard]] const char* error() const noexcept override;

  /// In a stand from now on, whatever the options were.
  bool clamp(const std::array<double, 3>& up) noexcept override;

  /// Places the robot on the floor with these joint angles (rad), at rest. The trunk pitches forward by `lean_rad`; in
  /// a stand it stays as it is. The ball is not moved.
  void place(const std::array<double, kJoints>& angles_rad, double lean_rad = 0);
  /// Applies a force to the trunk, N, in world axes: x forward, y left, z up at the start.
  void push(const std::array<double, 3>& force_n, Nanos duration) noexcept;
  /// Places the ball at rest, m.
  void placeBall(double x_m, double y_m) noexcept;
  void press(std::uint8_t buttons) noexcept;  // 1 MODE, 2 START

  [[nodiscard]] std::array<double, 3> trunkPosition() const noexcept;  // m, world
  /// Cosine of the tilt: 1 upright, 0 lying, -1 upside down.
  [[nodiscard]] double upright() const noexcept;
  /// Yaw of the trunk, rad from -pi to pi, counter-clockwise from the start; undefined when it lies.
  [[nodiscard]] double heading() const noexcept;
  [[nodiscard]] double time_s() const noexcept;

  /// For rendering and tests. Valid until the next call of place() or step().
  [[nodiscard]] const mjModel_* mujocoModel() const noexcept;
  [[nodiscard]] mjData_* mujocoData() noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace darwinop::twin
