// Time that a step of a manager stands for: what the controller declares, or the robot's time if its loop is slower.
#pragma once

#include <algorithm>
#include <cmath>

namespace managers {

/// Without a clock of its own: it is given the robot's time. Allocates nothing.
class StepClock {
 public:
  /// Greatest time of one step, ms: ten calls of the engines. A slower loop plays in slow motion.
  static constexpr double kMaxRoundMs = 80;
  /// A longer gap is a pause that the controller made, not a slow loop: it counts as declared.
  static constexpr double kPauseMs = 1000;

  /// ms to play in this step. `robot_ms`: the robot's time at the newest image; `cycle_ms`: period of its loop. The
  /// robot is ahead by less than a cycle in a loop that is in time, as with step(20) at 16 ms a cycle; what it is ahead
  /// by more is added in whole ticks.
  double advance(double declared_ms, double robot_ms, double cycle_ms) {
    const double passed_ms = known_ ? robot_ms - last_ms_ : declared_ms;
    known_ = true;
    last_ms_ = robot_ms;
    if (passed_ms > kPauseMs) return restarted(declared_ms);
    note(declared_ms, passed_ms);
    round_ms_ += kSmoothing * (std::max(passed_ms, declared_ms) - round_ms_);
    ahead_ms_ = std::max(-kMaxRoundMs, ahead_ms_ + passed_ms - declared_ms);  // images may come unevenly
    if (ahead_ms_ < cycle_ms) return declared_ms;
    const double all_ms = std::floor(ahead_ms_ / kTick) * kTick;
    const double added_ms = std::min(all_ms, std::max(0.0, kMaxRoundMs - declared_ms));
    ahead_ms_ -= all_ms;  // beyond the bound time is lost, not caught up with later
    return declared_ms + added_ms;
  }

  /// Nothing was played since: the next step counts as declared.
  void restart() { *this = {}; }

  /// Smoothed time of a round, ms: over about ten rounds.
  [[nodiscard]] double roundMs() const { return round_ms_; }
  /// Mean time of a round in the last two seconds, ms, if they and the two before were slower than declared by a tenth;
  /// otherwise 0. A single late round is not.
  [[nodiscard]] double slowRoundMs() const { return slow_ms_; }

 private:
  static constexpr double kTick = 8, kWindowMs = 2000;
  static constexpr double kSlower = 1.1;
  static constexpr double kSmoothing = 0.2;

  double restarted(double declared_ms) {
    ahead_ms_ = passed_ms_ = capped_ms_ = declared_ms_ = round_ms_ = 0;
    rounds_ = 0;
    return declared_ms;
  }

  void note(double declared_ms, double passed_ms) {
    slow_ms_ = 0;
    ++rounds_;
    declared_ms_ += declared_ms;
    passed_ms_ += passed_ms;
    capped_ms_ += std::min(passed_ms, std::max(declared_ms, kMaxRoundMs));
    if (passed_ms_ < kWindowMs) return;
    const bool slow = capped_ms_ > kSlower * declared_ms_;
    if (slow && was_slow_) slow_ms_ = passed_ms_ / rounds_;
    was_slow_ = slow;
    passed_ms_ = capped_ms_ = declared_ms_ = 0;
    rounds_ = 0;
  }

  bool known_ = false, was_slow_ = false;
  double last_ms_ = 0, ahead_ms_ = 0, round_ms_ = 0, slow_ms_ = 0;
  double passed_ms_ = 0, capped_ms_ = 0, declared_ms_ = 0;  // of the window
  int rounds_ = 0;
};

}  // namespace managers
