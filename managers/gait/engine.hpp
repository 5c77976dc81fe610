// Walking engine: 8 ms of walking per call. Pure computation of joint goals: no clock, no robot, no heap.
//
// Equal to the ROBOTIS engine of framework 1.6 in every tick, except for three defects of that engine:
//  - parameters apply from the first call; there, foot height and swings jumped in the middle of the first step,
//  - a stop between start() and the first call is obeyed; there, it was lost,
//  - goals are clamped to the joint ranges; there, to 0..4095.
#pragma once

#include <optional>

#include "managers/gait/balance.hpp"
#include "managers/gait/goals.hpp"
#include "managers/gait/parameters.hpp"
#include "managers/gait/stride.hpp"
#include "managers/gait/timing.hpp"

namespace darwinop::gait {

class Engine {
 public:
  explicit Engine(const Parameters& parameters);

  /// Continues from where it stopped, with the left or the right foot.
  void start();
  /// Applied when both feet are down, at t = 0 or half a period, before the next goals.
  void setParameters(const Parameters& parameters) { requested_ = parameters; }
  /// Ends in the stance: immediately when stepping in place, else within 1.5 periods.
  void stop();
  /// False once the walk has ended in the stance.
  [[nodiscard]] bool running() const { return running_; }

  /// The next 8 ms. The command takes effect in the middle of the next swing, not after stop(). `tilt` from the
  /// gyroscope; NaN disables balance. If a foot position is out of reach the goals are unchanged; after that, and when
  /// the feet open for a turn, they jump (servo_speed.hpp).
  const Goals& next(const WalkCommand& command, const Tilt& tilt);
  /// Goals of the last call; before the first, the stance.
  [[nodiscard]] const Goals& goals() const { return goals_; }
  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  [[nodiscard]] const Parameters& requestedParameters() const { return requested_ ? *requested_ : parameters_; }

 private:
  void applyParameters();
  void updatePhase();
  void finishIfStopping();

  Parameters parameters_;
  std::optional<Parameters> requested_;
  Timing timing_;
  WalkCommand command_;
  Stride stride_;
  Goals goals_ = kStanding;
  double time_ms_ = 0;
  bool running_ = false, stopping_ = false;
};

}  // namespace darwinop::gait
