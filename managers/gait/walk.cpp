// State machine of a walk: approach to the stance, gyroscope calibration, steps, rest.
#include "managers/gait/walk.hpp"

#include "managers/gait/servo_speed.hpp"

namespace darwinop::gait {

void Walk::start(const Pose& from) {
  stopping_ = false;
  if (phase_ == Phase::kWalk) return engine_.start();
  if (phase_ != Phase::kRest) return;
  approach_ = Approach{from, poseOf(engine_.goals())};
  phase_ = Phase::kApproach;
}

void Walk::setParameters(const Parameters& parameters) {
  engine_.setParameters(parameters);
  if (phase_ == Phase::kRest) engine_ = Engine{parameters};
}

void Walk::stop() {
  stopping_ = true;
  if (phase_ == Phase::kWalk) engine_.stop();
}

void Walk::abandon() {
  engine_ = Engine{engine_.requestedParameters()};
  pose_ = poseOf(engine_.goals());
  phase_ = Phase::kRest;
  stopping_ = false;
}

void Walk::tick(const WalkCommand& command, bool balance, const GyroCounts& gyro) {
  if (phase_ == Phase::kRest) return addSample(gyro);
  if (phase_ == Phase::kApproach) approach();
  if (phase_ == Phase::kCalibrate) calibrate(balance, gyro);
  if (phase_ == Phase::kWalk) walk(command, balance, gyro);
}

void Walk::approach() {
  if (!approach_.done()) {
    pose_ = approach_.next();
    return;
  }
  pose_ = poseOf(engine_.goals());
  waited_ = 0;
  centre_.restart();
  phase_ = Phase::kCalibrate;
}

void Walk::calibrate(bool balance, const GyroCounts& gyro) {
  if (stopping_) {
    phase_ = Phase::kRest;
  } else if (!balance || centre_.known() || waited_ >= kMaxReadings) {
    phase_ = Phase::kWalk;
    engine_.start();
  } else {
    addSample(gyro);
    if (gyro.fresh) ++waited_;
  }
}

void Walk::addSample(const GyroCounts& gyro) {
  if (gyro.fresh) centre_.add(gyro.roll, gyro.pitch);
}

void Walk::walk(const WalkCommand& command, bool balance, const GyroCounts& gyro) {
  const Tilt unknown{std::nan(""), std::nan("")};
  engine_.next(command, balance ? centre_.tilt(gyro.roll, gyro.pitch) : unknown);
  if (!engine_.running()) engine_.next({}, unknown);  // removes the balance correction of the last tick
  const Pose target = poseOf(engine_.goals());
  pose_ = atServoSpeed(pose_, target);
  if (!engine_.running() && pose_ == target) phase_ = Phase::kRest;
}

}  // namespace darwinop::gait
