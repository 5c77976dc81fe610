// Runs an experiment on a robot through the Webots API, and brings the robot back whatever happens.
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
constexpr double kFar = 0.1;        // rad
constexpr double kUsualGain = 4.0;  // as servos have it when they are new
}  // namespace

Runner::Runner(webots::Robot& robot, const Experiment& experiment, const std::atomic<bool>& stop, Tell tell)
    : robot_{robot},
      experiment_{experiment},
      stop_{stop},
      tell_{std::move(tell)},
      step_ms_{static_cast<int>(robot.getBasicTimeStep())},
      step_s_{step_ms_ / 1000.0},
      began_s_{robot.getTime()} {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const std::string name{kJointTable[i].name};
    wheels_[i].motor = robot.getMotor(name);
    wheels_[i].sensor = robot.getPositionSensor(name + "S");
    wheels_[i].sensor->enable(step_ms_);
    wheels_[i].goal = startPose()[i];
  }
  robot.getAccelerometer("Accelerometer")->enable(step_ms_);
}

Outcome Runner::run() {
  const Setup& setup = experiment_.setup;
  phase_ = "to the first pose";
  bool whole = moveTo(setup.pose, setup.duration_s, Stop::kHeeded) && settle(setup.settle_s);
  const bool fell = fall_.fallen();
  if (whole && !fell) whole = runRounds();
  const bool fell_in = !fell && fall_.fallen() && !may_fall_;
  goBack();
  if (ended_) return Outcome::kEnded;
  if (fell_in) return Outcome::kFellIn;
  return fell ? Outcome::kFell : whole ? Outcome::kDone : Outcome::kStopped;
}

bool Runner::runRounds() {
  for (const Round& round : experiment_.rounds)
    for (const Phase& phase : round.phases) {
      phase_ = round.label.empty() ? phase.name : round.label + ", " + phase.name;
      if (!runPhase(phase)) return false;
    }
  return true;
}

/// The way there backwards: what did not fall on its way up does not fall on its way down. A second wish to end is
/// heard by the API, which leaves the rest to the safety layer.
void Runner::goBack() {
  if (ended_) return;
  phase_ = "back to the start pose";
  restoreOthers(nullptr);
  double way = 0;
  for (std::size_t i = 0; i < kJoints; ++i) way = std::max(way, std::abs(wheels_[i].goal - experiment_.setup.pose[i]));
  (void)(moveTo(experiment_.setup.pose, slowTime(way), Stop::kIgnored) &&
         moveTo(startPose(), experiment_.setup.duration_s, Stop::kIgnored));
}

/// A straight line in joint space, smooth in time.
bool Runner::moveTo(const Pose& pose, double seconds, Stop stop) {
  Pose from{};
  for (std::size_t i = 0; i < kJoints; ++i) from[i] = wheels_[i].goal;
  const double start = now();
  for (double t = 0; t < seconds - step_s_ / 2 && going(stop); t = now() - start) {
    for (std::size_t i = 0; i < kJoints; ++i)
      wheels_[i].goal = from[i] + (pose[i] - from[i]) * smooth((t + step_s_) / seconds);
    if (!step()) return false;
  }
  return going(stop);
}

bool Runner::settle(double seconds) {
  const double start = now();
  while (now() - start < seconds - step_s_ / 2 && going(Stop::kHeeded))
    if (!step()) return false;
  return going(Stop::kHeeded);
}

bool Runner::runPhase(const Phase& phase) {
  begin(phase);
  may_fall_ = may_fall_ || phase.until == Until::kFallen;
  Pose from{};
  for (std::size_t i = 0; i < kJoints; ++i) from[i] = wheels_[i].goal;
  EndWatch end{phase, positions()};
  const double start = now();
  for (double t = 0; t < phase.duration_s - step_s_ / 2 && going(Stop::kHeeded); t = now() - start) {
    drive(phase, from, t + step_s_);
    if (fall_.fallen() && !may_fall_) return false;
    if (!step() || end.over(positions(), fall_.fallen(), now() - start)) break;
  }
  return going(Stop::kHeeded) && (may_fall_ || !fall_.fallen());
}

/// A phase stands alone: what it does not name is as usual.
void Runner::begin(const Phase& phase) {
  restoreOthers(&phase);
  for (const Moved& moved : phase.joints) {
    Wheel& wheel = wheels_[index(moved.joint)];
    if (wheel.loose || phase.goal.shape == Shape::kMove || phase.goal.shape == Shape::kRamp) startWhereItIs(wheel);
    wheel.motor->setVelocity(phase.velocity);
    wheel.motor->setAcceleration(phase.acceleration);
    wheel.motor->setControlPID(phase.p_gain, 0, 0);
    wheel.loose = phase.torque != TorqueMode::kLimit;
    wheel.pushed = phase.torque == TorqueMode::kDirect;
    wheel.changed = true;
  }
}

/// What the phase asks for at `t` seconds.
void Runner::drive(const Phase& phase, const Pose& from, double t) {
  for (const Moved& moved : phase.joints) {
    Wheel& wheel = wheels_[index(moved.joint)];
    if (phase.torque == TorqueMode::kLimit)
      wheel.goal = goalAt(phase.goal, phase.duration_s, moved.sign, from[index(moved.joint)], t);
    setTorque(wheel, phase, std::min(t / phase.duration_s, 1.0));
  }
}

void Runner::setTorque(Wheel& wheel, const Phase& phase, double share) {
  const double newton_meter = phase.newton_meter.at(share);
  if (phase.torque == TorqueMode::kOff) {
    wheel.motor->setAvailableTorque(0);
  } else if (phase.torque == TorqueMode::kDirect) {
    wheel.motor->setAvailableTorque(kMaxTorqueNm);
    wheel.motor->setTorque(newton_meter);
  } else {
    wheel.motor->setAvailableTorque(newton_meter);
  }
}

/// All joints that were changed, but those of `phase`.
void Runner::restoreOthers(const Phase* phase) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    Wheel& wheel = wheels_[i];
    const auto is_this = [i](const Moved& moved) { return index(moved.joint) == i; };
    if (!wheel.changed || (phase != nullptr && std::ranges::any_of(phase->joints, is_this))) continue;
    startWhereItIs(wheel);
    wheel.motor->setVelocity(kFullSpeed);
    wheel.motor->setAcceleration(-1);
    wheel.motor->setControlPID(kUsualGain, 0, 0);
    wheel.motor->setAvailableTorque(kMaxTorqueNm);
    wheel.changed = wheel.loose = wheel.pushed = false;
  }
}

/// A joint that hangs far from its goal, for want of torque or gain, would jump there once it has both.
void Runner::startWhereItIs(Wheel& wheel) {
  const double seen = wheel.sensor->getValue();
  if (!wheel.loose && !(std::abs(seen - wheel.goal) > kFar)) return;
  if (!std::isnan(seen)) wheel.goal = std::clamp(seen, wheel.motor->getMinPosition(), wheel.motor->getMaxPosition());
}

bool Runner::step() {
  for (Wheel& wheel : wheels_)
    if (!wheel.pushed) wheel.motor->setPosition(wheel.goal);
  tell_(phase_, now());
  if (robot_.step(step_ms_) == -1) ended_ = true;
  fall_.update(robot_.getAccelerometer("Accelerometer")->getValues(), step_s_);
  return !ended_;
}

Positions Runner::positions() const {
  Positions seen{};
  for (std::size_t i = 0; i < kJoints; ++i) seen[i] = wheels_[i].sensor->getValue();
  return seen;
}

double Runner::now() const {
  return robot_.getTime() - began_s_;
}

}  // namespace darwinop::experiments
