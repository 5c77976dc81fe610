// Body that samples its poses for drawing, without blocking.
#pragma once

#include <cstdint>
#include <memory>

#include "hal/body.hpp"
#include "twin/body/robot_body.hpp"
#include "twin/view/pose_ring.hpp"

namespace darwinop::twin {

/// Forwards to `body`; pushes a pose at the start and then `per_second` times per second of simulated time.
class WatchedBody final : public Body {
 public:
  WatchedBody(std::unique_ptr<RobotBody> body, int per_second);

  void step(Nanos dt, const Drives& drives) noexcept override;
  [[nodiscard]] const BodyState& state() const noexcept override { return body_->state(); }
  [[nodiscard]] const char* error() const noexcept override { return body_->error(); }

  [[nodiscard]] RobotBody& robot() noexcept { return *body_; }
  /// May be used by another thread while the body steps; everything else may not.
  [[nodiscard]] PoseRing& poses() noexcept { return *poses_; }

 private:
  std::unique_ptr<RobotBody> body_;
  std::unique_ptr<PoseRing> poses_ = std::make_unique<PoseRing>();
  double per_second_;
  std::uint64_t sampled_ = 0;  // poses so far, including dropped ones
};

}  // namespace darwinop::twin
