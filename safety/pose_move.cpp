// Monitors a slow move to one pose.
#include "safety/pose_move.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::safety {
namespace {

// Time-out: 1.5 times the nominal duration, plus two seconds for friction and loads.
constexpr double kPatience = 1.5;
constexpr double kSettle = 2.0;  // s

}  // namespace

void PoseMove::begin() noexcept {
  elapsed_ = deadline_ = Nanos{0};
  seen_.reset();
  missing_.reset();
}

PoseMove::Progress PoseMove::update(const Mask& moving, bool on_the_way, const Angles& position, const Angles& target,
                                    Nanos dt) noexcept {
  elapsed_ += dt;
  deadline_ = std::max(deadline_, fromSeconds(kSettle));
  missing_.reset();
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (!moving[i]) continue;
    const double way = std::abs(target[i].value - position[i].value);
    if (!seen_[i]) {  // a joint that is taken over later extends the deadline, once
      const double way_or_most = std::isfinite(way) ? way : 2 * kPi;
      deadline_ = std::max(deadline_, elapsed_ + fromSeconds(kPatience * way_or_most / config_.gentle_speed + kSettle));
    }
    missing_[i] = !(way <= config_.start_tolerance);
  }
  seen_ |= moving;
  if (elapsed_ >= deadline_) return Progress::kTimedOut;
  return missing_.none() && !on_the_way ? Progress::kArrived : Progress::kMoving;
}

}  // namespace darwinop::safety
