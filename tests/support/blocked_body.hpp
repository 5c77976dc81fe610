// A body with one knee that is blocked, and a servo that shuts itself off after two seconds at its torque limit.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"
#include "hil-mocks/plain_body.hpp"

namespace darwinop {

class BlockedBody : public Body {
 public:
  static constexpr Joint kKnee = Joint::kLegLowerR;
  static constexpr double kTripsAfter = 2.0;  // s

  /// `phase`: added to the time after which the servo trips.
  explicit BlockedBody(Nanos phase) : trips_after_{kTripsAfter + std::chrono::duration<double>(phase).count()} {}

  void block() {
    blocked_ = true;
    at_ = plain_.state().joint[index(kKnee)].position_rad;
  }
  [[nodiscard]] int trips() const { return trips_; }
  [[nodiscard]] double stalledFor() const { return stalled_; }
  [[nodiscard]] const BodyState& state() const noexcept override { return state_; }

  void step(Nanos dt, const Drives& drives) noexcept override {
    plain_.step(dt, drives);
    if (blocked_) plain_.place(kKnee, at_);
    state_ = plain_.state();
    if (!blocked_) return;
    const ServoDrive& drive = drives[index(kKnee)];
    JointMotion& knee = state_.joint[index(kKnee)];
    const double duty = drive.p_gain * (drive.goal_rad - at_) / (1023 * kRadPerTick);
    knee.load = drive.torque_on ? std::clamp(duty, -drive.torque_limit, drive.torque_limit) : 0;
    if (!drive.torque_on) {
      tripped_ = false;
      at_limit_ = 0;
    } else {
      const bool full = std::abs(knee.load) >= 0.3 && std::abs(knee.load) >= 0.98 * drive.torque_limit;
      const double seconds = std::chrono::duration<double>(dt).count();
      at_limit_ = full ? at_limit_ + seconds : 0;
      stalled_ += full ? seconds : 0;
      if (!tripped_ && at_limit_ > trips_after_) {
        tripped_ = true;
        ++trips_;
      }
    }
    knee.overload = tripped_;
  }

 private:
  hil::PlainBody plain_;
  BodyState state_ = plain_.state();
  double trips_after_, at_ = 0, at_limit_ = 0, stalled_ = 0;
  bool blocked_ = false, tripped_ = false;
  int trips_ = 0;
};

}  // namespace darwinop
