// Runs an experiment on a robot through the Webots API, and brings the robot back whatever happens.
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

enum class Outcome : std::uint8_t {
  kDone,
  kStopped,  // asked to end; the robot is back in its start pose
  kEnded,    // the robot or its safety layer ended it; the reason was told
  kFell,     // on its way to the first pose; nothing was measured
  kFellIn,   // in a phase that is not about falling; what comes after it was left out
};

/// Called in every step: the phase, seconds since the experiment began.
using Tell = std::function<void(const std::string& phase, double seconds)>;

class Runner {
 public:
  /// `stop` becomes true when the user asks for the end. All must outlive the runner.
  Runner(webots::Robot& robot, const Experiment& experiment, const std::atomic<bool>& stop, Tell tell);

  /// To the end, the way back included.
  [[nodiscard]] Outcome run();

 private:
  struct Wheel {
    webots::Motor* motor;
    webots::PositionSensor* sensor;
    double goal = 0;       // rad, asked for last
    bool loose = false;    // moved by its weight or a given torque: the goal says nothing about where it is
    bool pushed = false;   // by Motor::setTorque(), which a goal would end
    bool changed = false;  // its settings are not the usual ones
  };
  enum class Stop : std::uint8_t { kHeeded, kIgnored };

  [[nodiscard]] bool step();
  [[nodiscard]] bool moveTo(const Pose& pose, double seconds, Stop stop);
  [[nodiscard]] bool settle(double seconds);
  [[nodiscard]] bool runRounds();
  [[nodiscard]] bool runPhase(const Phase& phase);
  void goBack();
  void begin(const Phase& phase);
  void drive(const Phase& phase, const Pose& from, double t);
  void setTorque(Wheel& wheel, const Phase& phase, double share);
  void restoreOthers(const Phase* phase);
  void startWhereItIs(Wheel& wheel);
  [[nodiscard]] bool going(Stop stop) const { return !ended_ && (stop == Stop::kIgnored || !stop_); }
  [[nodiscard]] Positions positions() const;
  [[nodiscard]] double now() const;

  webots::Robot& robot_;
  const Experiment& experiment_;
  const std::atomic<bool>& stop_;
  Tell tell_;
  std::array<Wheel, kJoints> wheels_{};
  int step_ms_;
  double step_s_, began_s_;
  std::string phase_;  // for tell_
  bool ended_ = false;
  bool may_fall_ = false;  // the experiment has come to a phase that lasts until the robot has fallen
  FallWatch fall_;
};

}  // namespace darwinop::experiments
