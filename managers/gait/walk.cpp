// A whole walk: from any pose to the stance, standing still for the gyroscope, steps, and rest again.
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

void Walk::stop() {
  stopping_ = true;
  if (phase_ == Phase::kWalk) engine_.stop();
}

void Walk::abandon() {
  engine_ = Engine{engine_.parameters()};
  pose_ = poseOf(engine_.goals());
  phase_ = Phase::kRest;
  stopping_ = false;
}

void Walk::tick(const Wish& wish, bool balance, const GyroCounts& gyro) {
  if (phase_ == Phase::kRest) return learn(gyro);
  if (phase_ == Phase::kApproach) approach();
  if (phase_ == Phase::kSettle) settle(balance, gyro);
  if (phase_ == Phase::kWalk) walk(wish, balance, gyro);
}

void Walk::approach() {
  if (!approach_.done()) {
    pose_ = approach_.next();
    return;
  }
  pose_ = poseOf(engine_.goals());
  waited_ = 0;
  centre_.beginAgain();
  phase_ = Phase::kSettle;
}

void Walk::settle(bool balance, const GyroCounts& gyro) {
  if (stopping_) {
    phase_ = Phase::kRest;
  } else if (!balance || centre_.known() || waited_ >= kPatience) {
    phase_ = Phase::kWalk;
    engine_.start();
  } else {
    learn(gyro);
    if (gyro.fresh) ++waited_;
  }
}

void Walk::learn(const GyroCounts& gyro) {
  if (gyro.fresh) centre_.add(gyro.roll, gyro.pitch);
}

void Walk::walk(const Wish& wish, bool balance, const GyroCounts& gyro) {
  const Tilt unseen{std::nan(""), std::nan("")};
  engine_.next(wish, balance ? centre_.tilt(gyro.roll, gyro.pitch) : unseen);
  if (!engine_.running()) engine_.next({}, unseen);  // what balance added in the last tick is not for ever
  const Pose wanted = poseOf(engine_.goals());
  pose_ = atServoSpeed(pose_, wanted);
  if (!engine_.running() && pose_ == wanted) phase_ = Phase::kRest;
}

}  // namespace darwinop::gait
