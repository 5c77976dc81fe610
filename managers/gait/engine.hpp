// The walking engine: one call, 8 ms of walking. Plain numbers in, joint goals out; no clock, no robot, no heap.
//
// Tick for tick the ROBOTIS engine of the 1.6 framework, except for three of its slips:
//  - parameters hold from the first call; there, foot height and swings jumped in the middle of the first step,
//  - a stop between start() and the first call counts; there, it was lost,
//  - goals are clamped to the joints' ranges; there, to 0..4095.
#pragma once

#include "managers/gait/balance.hpp"
#include "managers/gait/goals.hpp"
#include "managers/gait/parameters.hpp"
#include "managers/gait/stride.hpp"
#include "managers/gait/timing.hpp"

namespace darwinop::gait {

class Engine {
 public:
  explicit Engine(const Parameters& parameters);

  /// Goes on from where it stopped, with the left or the right foot.
  void start();
  /// Ends at rest: at once when stepping in place, else within one and a half periods.
  void stop();
  /// True until the goals are those of standing, for good.
  [[nodiscard]] bool running() const { return running_; }

  /// The next 8 ms. The wish is followed from the middle of the next swing, and not any more after stop(). `tilt` is
  /// what the gyroscope saw; one that is not known leaves the balance alone. A place out of a leg's reach keeps the
  /// goals as they are; after it, and when feet open for a turn, they jump (servo_speed.hpp).
  const Goals& next(const Wish& wish, const Tilt& tilt);
  /// Those of the last call; before the first, standing.
  [[nodiscard]] const Goals& goals() const { return goals_; }
  [[nodiscard]] const Parameters& parameters() const { return parameters_; }

 private:
  void turnThePage();
  void comeToRest();

  Parameters parameters_;
  Timing timing_;
  Wish wish_;
  Stride stride_;
  Goals goals_ = kStanding;
  double time_ms_ = 0;
  bool running_ = false, stopping_ = false;
};

}  // namespace darwinop::gait
