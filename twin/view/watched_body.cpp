#include "twin/view/watched_body.hpp"

namespace darwinop::twin {

WatchedBody::WatchedBody(std::unique_ptr<RobotBody> body, int per_second)
    : body_{std::move(body)}, per_second_{static_cast<double>(per_second)} {
  poses_->push(poseOf(*body_));
  ++seen_;
}

void WatchedBody::step(Nanos dt, const Drives& drives) noexcept {
  body_->step(dt, drives);
  if (body_->time_s() * per_second_ < static_cast<double>(seen_)) return;
  poses_->push(poseOf(*body_));
  ++seen_;
}

}  // namespace darwinop::twin
