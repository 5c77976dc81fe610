// Whether the robot has executed a motion's goals: safety also holds, kneels or takes over, and a board may be silent.
#pragma once

#include <algorithm>

#include "core/faults.hpp"

namespace darwinop::body_player {

/// A motion waits while the robot does not follow, and ends after kMaxWaitMs: by then the robot may have fallen, or
/// somebody may hold it, and the motion would continue far from its pose.
class Following {
 public:
  static constexpr double kMaxWaitMs = 300;

  /// `ms`: time since the last call; a call that does not follow counts as 1 ms at least.
  void update(State state, double ms) { lost_ms_ = state == State::kDriven ? 0 : lost_ms_ + std::max(ms, 1.0); }

  /// At the last update().
  [[nodiscard]] bool isGiven() const { return lost_ms_ == 0; }
  /// Not for longer than a motion waits.
  [[nodiscard]] bool isLost() const { return lost_ms_ > kMaxWaitMs; }

 private:
  double lost_ms_ = 0;
};

}  // namespace darwinop::body_player
