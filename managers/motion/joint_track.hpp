// Trajectory of one joint in a step: acceleration, constant speed, deceleration, in integer arithmetic.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/conversions.hpp"

namespace darwinop::motion {

/// Durations of a step's sections, in ticks of 8 ms.
struct StepTimes {
  int total = 0;         // of the motion, without the pause
  int acceleration = 0;  // of the first and of the last section

  [[nodiscard]] constexpr int main() const { return total - 2 * acceleration; }

  /// Shortens the acceleration of a short step to what fits; a step too short for any acceleration has no motion.
  static constexpr StepTimes fitted(int total, int acceleration) {
    if (total > 2 * acceleration) return {total, acceleration};
    const int fits = total > 0 ? (total - 1) / 2 : 0;
    return {fits == 0 ? 0 : total, fits};
  }
};

/// Equal to the vendor's engine in every tick: "/" truncates towards zero, ">>" rounds down.
/// Positions in servo ticks; speeds in an internal unit, at most 1023.
class JointTrack {
 public:
  /// At rest at `position`.
  void rest(int position) {
    *this = {};
    start_ = target_ = output_ = position;
  }

  /// Starts a step. `ends`: the joint stops at its target.
  void prepare(int target, bool ends, StepTimes times) {
    start_ = target_;  // target of the last step, which may differ by some ticks from its last output
    target_ = target;
    ends_ = ends;
    distance_ = target_ - start_;
    accelerated_ = 0;
    const int periods = (ends ? 0 : 2 * times.acceleration) + 4 * (times.total - times.acceleration);
    const int wanted = 2560 * distance_ / 12 - entry_speed_ * 2 * times.acceleration;
    main_speed_ = std::clamp(wanted / std::max(1, periods), -kMaxSpeed, kMaxSpeed);
  }

  /// Ends a section; its final speed is the initial speed of the next.
  void endSection() {
    start_ = output_;
    entry_speed_ = speed_;
  }
  void beginMain(StepTimes times) {
    if (ends_)
      main_distance_ = distance_ - accelerated_ - ((main_speed_ * times.acceleration * 12 / 5) >> 8);
    else
      main_distance_ = times.total == times.acceleration
                           ? 0
                           : (distance_ - accelerated_) * times.main() / (times.total - times.acceleration);
  }
  void beginSlowDown() { main_distance_ = distance_ - main_distance_ - accelerated_; }
  void endPause() { speed_ = entry_speed_ = 0; }

  // Tick `c` of the `n` of a section, 1 to n.
  void speedUp(int c, int n) {
    if (stays()) return;
    accelerated_ = ramp(main_speed_ - entry_speed_, c, n);
    put(start_ + accelerated_);
  }
  void cruise(int c, int n) {
    if (stays()) return;
    speed_ = main_speed_;
    put(start_ + main_distance_ * c / n);
  }
  void slowDown(int c, int n) {
    if (stays()) return;
    if (c == n - 1)
      put(target_);  // one tick early, then the formula again, as in the vendor's engine
    else if (ends_)
      put(start_ + ramp(-entry_speed_, c, n));
    else
      cruise(c, n);
  }

  [[nodiscard]] int output() const { return output_; }
  [[nodiscard]] int target() const { return target_; }

 private:
  static constexpr int kMaxSpeed = 1023;

  bool stays() {
    if (distance_ != 0) return false;
    put(start_);
    return true;
  }
  /// Distance since the start of a section over which the speed changes by `change`.
  int ramp(int change, int c, int n) {
    const int gained = change * c / n;
    speed_ = entry_speed_ + gained;
    return ((entry_speed_ + (gained >> 1)) * c * 144 / 15) >> 9;
  }
  void put(int position) { output_ = std::clamp(position, 0, kTickMax); }

  int start_ = 0, target_ = 0, output_ = 0;
  int distance_ = 0, accelerated_ = 0, main_distance_ = 0;
  int entry_speed_ = 0, speed_ = 0, main_speed_ = 0;
  bool ends_ = true;
};

}  // namespace darwinop::motion
