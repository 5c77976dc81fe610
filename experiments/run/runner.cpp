// Runs an experiment through the Webots API and returns the robot to its start pose.
#include "experiments/run/runner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <webots/Accelerometer.hpp>
#include <webots/Motor.hpp>
#include <webots/PositionSensor.hpp>
#include <webots/Robot.hpp>

#include "core/conversions.hpp"
#include "experiments/format/plan.hpp"
#include "experiments/format/shape.hpp"

namespace darwinop::experiments {
namespace {
constexpr double kFar = 0.1;  // rad
}  // namespace

Runner::Runner(webots::Robot& robot, const Experiment& experiment, const std::atomic<bool>& stop,
               ProgressCallback on_step)
    : robot_{robot},
      experiment_{experiment},
      stop_{stop},
      on_step_{std::move(on_step)},
      step_ms_{static_cast<int>(robot.getBasicTimeStep())},
      step_s_{step_ms_ / 1000.0},
      start_s_{robot.getTime()} {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const std::string name{kJointTable[i].name};
    joints_[i].motor = robot.getMotor(name);
    joints_[i].sensor = robot.getPositionSensor(name + "S");
    joints_[i].sensor->enable(step_ms_);
    joints_[i].goal = startPose()[i];
  }
  if (auto* const accelerometer = robot.getAccelerometer("Accelerometer")) accelerometer->enable(step_ms_);
}

RunOutcome Runner::run() {
  const ExperimentSetup& setup = experiment_.setup;
  phase_ = kSetupPhase;
  bool complete = moveTo(setup.pose, setup.duration_s, Stop::kAllowed) && wait(setup.settle_s);
  const bool fell = fall_.fallen();
  if (complete && !fell) complete = runRounds();
  const bool fell_in_phase = !fell && fall_.fallen() && !may_fall_;
  goBack();
  if (ended_) return RunOutcome::kEnded;
  if (fell_in_phase) return RunOutcome::kFellIn;
  return fell ? RunOutcome::kFell : complete ? RunOutcome::kDone : RunOutcome::kStopped;
}

bool Runner::runRounds() {
  for (const Round& round : experiment_.rounds)
    for (const Phase& phase : round.phases) {
      phase_ = round.label.empty() ? phase.name : round.label + ", " + phase.name;
      if (!runPhase(phase)) return false;
    }
  return true;
}

/// Reverses the motion to the setup pose, which is known not to make the robot fall. A second stop signal is handled by
/// the API, which hands over to the safety layer.
void Runner::goBack() {
  if (ended_) return;
  phase_ = kReturnPhase;
  restoreOthers(nullptr);
  double distance = 0;
  for (std::size_t i = 0; i < kJoints; ++i)
    distance = std::max(distance, std::abs(joints_[i].goal - experiment_.setup.pose[i]));
  (void)(moveTo(experiment_.setup.pose, slowTime(distance), Stop::kIgnored) &&
         moveTo(startPose(), experiment_.setup.duration_s, Stop::kIgnored));
}

/// A straight line in joint space, smooth in time.
bool Runner::moveTo(const Pose& pose, double seconds, Stop stop) {
  Pose from{};
  for (std::size_t i = 0; i < kJoints; ++i) from[i] = joints_[i].goal;
  const double start = now();
  for (double t = 0; t < seconds - step_s_ / 2 && going(stop); t = now() - start) {
    for (std::size_t i = 0; i < kJoints; ++i)
      joints_[i].goal = from[i] + (pose[i] - from[i]) * smooth((t + step_s_) / seconds);
    if (!step()) return false;
  }
  return going(stop);
}

bool Runner::wait(double seconds) {
  const double start = now();
  while (now() - start < seconds - step_s_ / 2 && going(Stop::kAllowed))
    if (!step()) return false;
  return going(Stop::kAllowed);
}

bool Runner::runPhase(const Phase& phase) {
  begin(phase);
  may_fall_ = may_fall_ || phase.until == Until::kFallen;
  Pose from{};
  for (std::size_t i = 0; i < kJoints; ++i) from[i] = joints_[i].goal;
  EndWatch end{phase, positions()};
  const double start = now();
  for (double t = 0; t < phase.duration_s - step_s_ / 2 && going(Stop::kAllowed); t = now() - start) {
    drive(phase, from, t + step_s_);
    if (fall_.fallen() && !may_fall_) return false;
    if (!step() || end.isOver(positions(), fall_.fallen(), now() - start)) break;
  }
  return going(Stop::kAllowed) && (may_fall_ || !fall_.fallen());
}

/// Phases are independent: joints that a phase does not name have default settings.
void Runner::begin(const Phase& phase) {
  restoreOthers(&phase);
  for (const Moved& moved : phase.joints) {
    DrivenJoint& joint = joints_[index(moved.joint)];
    if (joint.loose || phase.goal.shape == Shape::kMove || phase.goal.shape == Shape::kRamp)
      startAtPresentPosition(joint);
    joint.motor->setVelocity(phase.velocity);
    joint.motor->setAcceleration(phase.acceleration);
    joint.motor->setControlPID(phase.p_gain, 0, 0);
    joint.loose = phase.torque != TorqueMode::kLimit;
    joint.pushed = phase.torque == TorqueMode::kDirect;
    joint.changed = true;
  }
}

/// Commands of the phase at `t` seconds.
void Runner::drive(const Phase& phase, const Pose& from, double t) {
  for (const Moved& moved : phase.joints) {
    DrivenJoint& joint = joints_[index(moved.joint)];
    if (phase.torque == TorqueMode::kLimit)
      joint.goal = goalAt(phase.goal, phase.duration_s, moved.sign, from[index(moved.joint)], t);
    setTorque(joint, phase, std::min(t / phase.duration_s, 1.0));
  }
}

void Runner::setTorque(DrivenJoint& joint, const Phase& phase, double share) {
  const double newton_meter = phase.newton_meter.at(share);
  if (phase.torque == TorqueMode::kOff) {
    joint.motor->setAvailableTorque(0);
  } else if (phase.torque == TorqueMode::kDirect) {
    joint.motor->setAvailableTorque(kMaxTorqueNm);
    joint.motor->setTorque(newton_meter);
  } else {
    joint.motor->setAvailableTorque(newton_meter);
  }
}

/// Restores default settings of all changed joints except those of `phase`.
void Runner::restoreOthers(const Phase* phase) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    DrivenJoint& joint = joints_[i];
    const auto is_this = [i](const Moved& moved) { return index(moved.joint) == i; };
    if (!joint.changed || (phase != nullptr && std::ranges::any_of(phase->joints, is_this))) continue;
    startAtPresentPosition(joint);
    joint.motor->setVelocity(kFullSpeed);
    joint.motor->setAcceleration(-1);
    joint.motor->setControlPID(kDefaultPGain, 0, 0);
    joint.motor->setAvailableTorque(kMaxTorqueNm);
    joint.changed = joint.loose = joint.pushed = false;
  }
}

/// A joint far from its goal, for lack of torque or gain, would jump to it when both return.
void Runner::startAtPresentPosition(DrivenJoint& joint) {
  const double measured = joint.sensor->getValue();
  if (!joint.loose && !(std::abs(measured - joint.goal) > kFar)) return;
  if (!std::isnan(measured))
    joint.goal = std::clamp(measured, joint.motor->getMinPosition(), joint.motor->getMaxPosition());
}

bool Runner::step() {
  for (DrivenJoint& joint : joints_)
    if (!joint.pushed) joint.motor->setPosition(joint.goal);
  on_step_(phase_, now());
  if (robot_.step(step_ms_) == -1) ended_ = true;
  auto* const accelerometer = robot_.getAccelerometer("Accelerometer");
  if (!experiment_.setup.is_clamped && accelerometer != nullptr) fall_.update(accelerometer->getValues(), step_s_);
  return !ended_;
}

Positions Runner::positions() const {
  Positions measured{};
  for (std::size_t i = 0; i < kJoints; ++i) measured[i] = joints_[i].sensor->getValue();
  return measured;
}

double Runner::now() const {
  return robot_.getTime() - start_s_;
}

}  // namespace darwinop::experiments
