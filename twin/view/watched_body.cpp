// Samples poses at a fixed rate of simulated time.
#include "twin/view/watched_body.hpp"

namespace darwinop::twin {

WatchedBody::WatchedBody(std::unique_ptr<RobotBody> body, int per_second)
    : body_{std::move(body)}, per_second_{static_cast<double>(per_second)} {
  poses_->push(poseOf(*body_));
  ++sampled_;
}

void WatchedBody::step(Nanos dt, const Drives& drives) noexcept {
  body_->step(dt, drives);
  if (body_->time_s() * per_second_ < static_cast<double>(sampled_)) return;
  poses_->push(poseOf(*body_));
  ++sampled_;
}

}  // namespace darwinop::twin
