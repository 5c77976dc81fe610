// A body that leaves a trail of poses for whoever draws it, and never waits for him.
#pragma once

#include <cstdint>
#include <memory>

#include "hal/body.hpp"
#include "twin/body/robot_body.hpp"
#include "twin/view/pose_ring.hpp"

namespace darwinop::twin {

/// The same body; a pose goes into the ring at the start and then `per_second` times a second of its own clock.
class WatchedBody final : public Body {
 public:
  WatchedBody(std::unique_ptr<RobotBody> body, int per_second);

  void step(Nanos dt, const Drives& drives) noexcept override;
  [[nodiscard]] const BodyState& state() const noexcept override { return body_->state(); }
  [[nodiscard]] const char* trouble() const noexcept override { return body_->trouble(); }

  [[nodiscard]] RobotBody& robot() noexcept { return *body_; }
  /// The one thing that another thread may use while the body steps.
  [[nodiscard]] PoseRing& poses() noexcept { return *poses_; }

 private:
  std::unique_ptr<RobotBody> body_;
  std::unique_ptr<PoseRing> poses_ = std::make_unique<PoseRing>();
  double per_second_;
  std::uint64_t seen_ = 0;  // poses so far, dropped ones too
};

}  // namespace darwinop::twin
