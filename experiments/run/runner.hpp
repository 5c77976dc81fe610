// Runs an experiment through the Webots API and returns the robot to its start pose.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <string>

#include "experiments/format/experiment.hpp"
#include "experiments/run/watch.hpp"

namespace webots {
class Motor;
class PositionSensor;
class Robot;
}  // namespace webots

namespace darwinop::experiments {

enum class RunOutcome : std::uint8_t {
  kDone,
  kStopped,  // by the user; the robot is back in its start pose
  kEnded,    // by the robot or its safety layer, which logged the reason
  kFell,     // before the first phase; nothing was measured
  kFellIn,   // in a phase without until = fallen; later phases were skipped
};

// Phases that every experiment has, before and after its own.
inline constexpr const char* kSetupPhase = "to the setup pose";
inline constexpr const char* kReturnPhase = "back to the start pose";

/// Called in every step: the phase, seconds since the experiment began.
using ProgressCallback = std::function<void(const std::string& phase, double seconds)>;

class Runner {
 public:
  /// `stop` becomes true on a stop request. All arguments must outlive the runner.
  Runner(webots::Robot& robot, const Experiment& experiment, const std::atomic<bool>& stop, ProgressCallback on_step);

  /// Runs the experiment including the return to the start pose.
  [[nodiscard]] RunOutcome run();

 private:
  struct DrivenJoint {
    webots::Motor* motor;
    webots::PositionSensor* sensor;
    double goal = 0;       // rad, last command
    bool loose = false;    // moved by gravity or a commanded torque: position unrelated to the goal
    bool pushed = false;   // by Motor::setTorque(), which a position goal would end
    bool changed = false;  // has non-default settings
  };
  enum class Stop : std::uint8_t { kAllowed, kIgnored };

  [[nodiscard]] bool step();
  [[nodiscard]] bool moveTo(const Pose& pose, double seconds, Stop stop);
  [[nodiscard]] bool wait(double seconds);
  [[nodiscard]] bool runRounds();
  [[nodiscard]] bool runPhase(const Phase& phase);
  void goBack();
  void begin(const Phase& phase);
  void drive(const Phase& phase, const Pose& from, double t);
  void setTorque(DrivenJoint& joint, const Phase& phase, double share);
  void restoreOthers(const Phase* phase);
  void startAtPresentPosition(DrivenJoint& joint);
  [[nodiscard]] bool going(Stop stop) const { return !ended_ && (stop == Stop::kIgnored || !stop_); }
  [[nodiscard]] Positions positions() const;
  [[nodiscard]] double now() const;

  webots::Robot& robot_;
  const Experiment& experiment_;
  const std::atomic<bool>& stop_;
  ProgressCallback on_step_;
  std::array<DrivenJoint, kJoints> joints_{};
  int step_ms_;
  double step_s_, start_s_;
  std::string phase_;  // for on_step_
  bool ended_ = false;
  bool may_fall_ = false;  // after the start of a phase with until = fallen
  FallWatch fall_;
};

}  // namespace darwinop::experiments
