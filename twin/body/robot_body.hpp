// The whole robot: twenty servo models on a MuJoCo body that falls, swings and slips.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "hal/body.hpp"
#include "twin/model/model.hpp"

struct mjModel_;
struct mjData_;

namespace darwinop::twin {

/// What lies on the floor before the robot: nothing, a ball at rest, or one that somebody leads round in a circle.
enum class Ball { kNone, kRests, kCircles };

struct RobotBodyOptions {
  std::uint64_t seed = 1;  // of noise; the same seed gives the same run to the last bit
  Ball ball = Ball::kRests;
};

/// DARWINOP_TWIN_BALL: none, rests (or nothing), circles. Throws std::runtime_error for another word.
Ball ballFromEnvironment();

/// Starts in the start pose, kneeling on the floor, at rest. Throws std::runtime_error for a model that MuJoCo refuses.
/// Not thread-safe; step() allocates nothing.
class RobotBody final : public Body {
 public:
  explicit RobotBody(const Model& model, const RobotBodyOptions& options = {});
  ~RobotBody() override;

  /// `dt` is gone through in steps of the model; what is left is kept for the next call.
  void step(Nanos dt, const Drives& drives) noexcept override;
  [[nodiscard]] const BodyState& state() const noexcept override;
  [[nodiscard]] const char* trouble() const noexcept override;

  /// Puts the robot on the floor with these joint angles (rad), at rest, what is lowest touching. The trunk is upright,
  /// or leans forward by `lean_rad`. The ball stays where it is.
  void place(const std::array<double, kJoints>& angles_rad, double lean_rad = 0);
  /// Pushes the trunk for so long with this force, N, world axes: x forward, y left, z up at the start.
  void push(const std::array<double, 3>& force_n, Nanos duration) noexcept;
  /// Puts the ball there, m, at rest.
  void placeBall(double x_m, double y_m) noexcept;
  void press(std::uint8_t buttons) noexcept;  // 1 MODE, 2 START

  [[nodiscard]] std::array<double, 3> trunkPosition() const noexcept;  // m, world
  /// 1 upright, 0 lying, -1 upside down: cosine between the trunk's up and the world's.
  [[nodiscard]] double upright() const noexcept;
  /// Which way the trunk faces, rad from -pi to pi, counter-clockwise from the start; means nothing when it lies.
  [[nodiscard]] double heading() const noexcept;
  [[nodiscard]] double time_s() const noexcept;

  /// For drawing, and for checks against the model. Valid until the next call of place() or step().
  [[nodiscard]] const mjModel_* mujocoModel() const noexcept;
  [[nodiscard]] mjData_* mujocoData() noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace darwinop::twin
