// All that protects one joint.
#include "safety/joint_guard.hpp"

#include <algorithm>

namespace darwinop::safety {

JointGuard::JointGuard(Joint joint, const Config& config)
    : config_{config}, range_{config.range[index(joint)]}, watch_{config} {
  forgetWishes();
}

void JointGuard::forgetWishes() noexcept {
  wish_goal_ = Rad{};
  wish_speed_ = RadPerSec{config_.default_speed};
  wish_torque_ = NewtonMeter{config_.default_torque};
  wish_p_gain_ = config_.default_p_gain;
  limp_ = false;
}

void JointGuard::listen(const JointCommand& asked, LimitHits& hits) noexcept {
  if (asked.has(JointCommand::kGoal)) wish_goal_ = limitGoal(asked.goal, wish_goal_, range_, hits);
  if (asked.has(JointCommand::kSpeedLimit)) wish_speed_ = limitSpeed(asked.speed_limit, wish_speed_, hits);
  if (asked.has(JointCommand::kTorqueLimit)) wish_torque_ = limitTorque(asked.torque_limit, wish_torque_, hits);
  if (asked.has(JointCommand::kPGain)) wish_p_gain_ = limitGain(asked.p_gain, wish_p_gain_, hits);
  if (asked.has(JointCommand::kTorque)) takeTorqueWish(asked.torque_on);
}

void JointGuard::takeTorqueWish(bool on) noexcept {
  if (!on && !limp_) orderOff();
  if (on && limp_) resetTrip();  // off and on again is how a controller asks for a tripped joint
  limp_ = !on;
}

void JointGuard::wishIfNone(Rad goal) noexcept {
  if (!wish_goal_.known()) wish_goal_ = goal;
}

void JointGuard::observe(const JointSensors& seen, bool given_up, Nanos powered_for, Nanos dt) noexcept {
  watch_.update(seen, given_up, powered_for, dt);
  const TripWatch::Verdict verdict = trip_watch_.update(seen, channel_.drivenFor());
  const bool was_suspect = suspect_;
  suspect_ = verdict == TripWatch::Verdict::kSuspect;
  // Suspected wrongly, or back by itself: it may have been off, and swung away from its last goal.
  if (was_suspect && !suspect_) restart();
  if (verdict == TripWatch::Verdict::kOverload) trip_ = Trip::kOverload;
  if (verdict == TripWatch::Verdict::kOverheat) trip_ = Trip::kOverheat;
  if (verdict == TripWatch::Verdict::kLostPower || watch_.lost() || given_up) restart();
  if (seen.health.fresh()) stiff_ = seen.torque_enabled;
  if (watch_.lost()) stiff_ = false;
  if (off_ordered_ && seen.health.fresh() && seen.torque_enabled) orderOff();
  channel_.observe(seen, dt);
}

void JointGuard::resetTrip() noexcept {
  trip_ = Trip::kNone;
  trip_watch_.forget();
}

void JointGuard::engage(bool wanted) noexcept {
  if (!wanted || limp_ || trip_ != Trip::kNone)
    channel_.leaveOut();
  else if (channel_.out())
    channel_.restart();
}

void JointGuard::restart() noexcept {
  if (!channel_.out()) channel_.restart();
}

void JointGuard::switchTorque(bool on) noexcept {
  if (off_due_) {
    off_due_ = false;
    off_ordered_ = true;
  }
  if (on && onDue()) channel_.torqueOn();
}

bool JointGuard::move(Rad target, double gentle_step, double full_step) noexcept {
  if (channel_.ready()) {
    channel_.place(range_);
    off_ordered_ = false;
    return true;
  }
  if (channel_.placed()) channel_.placeAgain();
  if (!channel_.moving() || !target.known()) return true;
  return channel_.advance(target, gentle_step, full_step);
}

SafeCommands::JointGoal JointGuard::goal(RadPerSec speed_cap, bool by_itself) const noexcept {
  const double cap = channel_.gentle() ? std::min(config_.gentle_speed, speed_cap.value) : speed_cap.value;
  if (by_itself) return {channel_.goal(), RadPerSec{cap}, NewtonMeter{config_.default_torque}, config_.default_p_gain};
  return {channel_.goal(), RadPerSec{std::min(wish_speed_.value, cap)}, wish_torque_, wish_p_gain_};
}

}  // namespace darwinop::safety
