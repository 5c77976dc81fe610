// Safety of one joint.
#include "safety/joint_guard.hpp"

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"

namespace darwinop::safety {

JointGuard::JointGuard(Joint joint, const Config& config)
    : config_{config},
      joint_{joint},
      absent_{config.absent[index(joint)]},
      no_writes_{absent_ || config.no_writes[index(joint)]},
      never_driven_{no_writes_ || config.left_out[index(joint)]},
      watch_{config} {
  forgetRequests();
}

void JointGuard::forgetRequests() noexcept {
  requested_goal_ = Rad{};
  requested_speed_ = RadPerSec{config_.default_speed};
  requested_torque_ = NewtonMeter{config_.default_torque};
  requested_p_gain_ = config_.default_p_gain;
  limp_ = false;
}

void JointGuard::takeSettings(const JointCommand& asked, LimitHits& hits) noexcept {
  if (asked.has(JointCommand::kSpeedLimit)) requested_speed_ = limitSpeed(asked.speed_limit, requested_speed_, hits);
  if (asked.has(JointCommand::kTorqueLimit))
    requested_torque_ = limitTorque(asked.torque_limit, requested_torque_, hits);
  if (asked.has(JointCommand::kPGain)) requested_p_gain_ = limitGain(asked.p_gain, requested_p_gain_, hits);
  if (asked.has(JointCommand::kTorque)) takeTorqueRequest(asked.torque_on);
}

void JointGuard::takeTorqueRequest(bool on) noexcept {
  if (!on && !limp_) orderOff();
  if (on && limp_) resetTrip();  // off and on again is a controller's request to reset the trip
  limp_ = !on;
}

void JointGuard::requestIfNone(Rad goal) noexcept {
  if (!requested_goal_.known()) requested_goal_ = goal;
}

FaultSet JointGuard::faults() const noexcept {
  return faultIf(watch_.silent() || unresponsive(), Fault::kServoSilent) | faultIf(watch_.hot(), Fault::kServoHot) |
         faultIf(watch_.overheated() || trip_ == Trip::kOverheat, Fault::kServoOverheat) |
         faultIf(trip_ == Trip::kOverload, Fault::kServoOverload) | faultIf(watch_.badVoltage(), Fault::kServoVoltage) |
         faultIf(encoder_watch_.stuck(), Fault::kEncoderStuck);
}

/// Lower bound of the torque of the servo's P controller, N m. 0: not driven, driven so slowly that the goal does not
/// determine the torque, or too small to count.
inline double JointGuard::push(const JointSensors& seen) const noexcept {
  constexpr double kFastEnough = 0.5;                                       // rad/s
  if (!channel_.moving() || suspected_ || uncertain_) return 0;             // the last goal may not have arrived
  const double gain = std::min(requested_p_gain_, config_.default_p_gain);  // safety's own moves use the default
  const double torque = gain * (channel_.goal().value - seen.position.value) / kFullDriveError * kMaxTorqueNm;
  if (std::abs(torque) < EncoderWatch::kPush) return 0;
  const double speed =
      channel_.gentle() ? std::min(requested_speed_.value, config_.gentle_speed) : requested_speed_.value;
  if (!(speed >= kFastEnough)) return 0;
  const double limit = std::min(std::min(requested_torque_.value, config_.default_torque), seen.torque_limit.value);
  return limit > 0 ? std::copysign(std::min(std::abs(torque), limit), torque) : 0;
}

/// A poll shows whether the servo has restarted: its moving speed is then 0, and torque is off unless a goal switched
/// it on again. (A servo that shut itself off has torque limit 0: TripWatch.)
inline void JointGuard::noteRestart(const JointSensors& seen) noexcept {
  const bool polled = seen.motion.fresh() && seen.polled.fresh();
  const bool off = polled && !seen.torque_enabled && seen.torque_limit.value > 0;
  const bool never_on = !on_seen_ || uncertain_;  // torque on was lost, or the servo has restarted
  const bool restarted = polled && (seen.speed_limit.value <= 0 || (off && never_on && channel_.moving()));
  if (polled && seen.torque_enabled) on_seen_ = true;
  // Restarted while silent, and has torque: a stalled board has executed an earlier goal, without a speed limit.
  if (polled && uncertain_ && had_limit_ && seen.speed_limit.value <= 0 && seen.torque_enabled) orderOff();
  if (polled) had_limit_ = seen.speed_limit.value > 0;
  if (!seen.motion.fresh())
    uncertain_ = true;
  else if (polled)
    uncertain_ = false;
  const bool doubtful = channel_.placed() && uncertain_;  // the position must be certain until torque is on
  if (channel_.hasGoal() && (restarted || doubtful || seen.motion.age > kAnswerPatience)) restart();
}

/// A placed goal can be lost on the bus. The position must then be confirmed again before the goal is placed again.
inline void JointGuard::notePlaced(const JointSensors& seen) noexcept {
  constexpr double kTolerance = kRadPerTick;              // rounding is half of it
  constexpr double kSpeedTolerance = kRadPerSecPerCount;  // as above
  has_goal_ = false;
  if (channel_.out()) refused_ = 0;
  if (!channel_.placed() || !seen.motion.fresh() || !seen.polled.fresh()) return;
  const bool took = std::abs(seen.goal.value - channel_.goal().value) <= kTolerance && seen.speed_limit.value > 0 &&
                    seen.speed_limit.value <= config_.gentle_speed + kSpeedTolerance;
  // The torque limit was written with the goal: a limit of 0 means that the servo shut itself off since. Needs two
  // readings.
  const bool shut = took && seen.torque_limit.value <= 0;
  if (shut && shut_at_once_) trip_ = Trip::kOverload;
  shut_at_once_ = shut && !shut_at_once_;
  has_goal_ = took && !shut;
  refused_ = took ? 0 : std::min(refused_ + 1, kRefusals);
  if (!has_goal_) restart();
}

void JointGuard::observe(const JointSensors& seen, bool given_up, Nanos powered_for, Nanos dt) noexcept {
  if (absent_) return;
  watch_.update(seen, given_up, powered_for, dt);
  notePlaced(seen);
  noteRestart(seen);
  const TripWatch::Verdict verdict = trip_watch_.update(seen, channel_.drivenFor());
  const bool was_suspected = suspected_;
  suspected_ = verdict == TripWatch::Verdict::kSuspected;
  if (verdict == TripWatch::Verdict::kOverload) trip_ = Trip::kOverload;
  if (verdict == TripWatch::Verdict::kOverheat) trip_ = Trip::kOverheat;
  // No longer suspected, or torque is off (kNotOn): the joint may have moved away from its last goal.
  if ((was_suspected && !suspected_) || watch_.lost() || given_up) restart();
  if (seen.polled.fresh()) {
    stiff_ = seen.torque_enabled;
    torque_known_ = true;
  }
  if (watch_.lost()) stiff_ = torque_known_ = false;
  if (off_ordered_ && seen.polled.fresh() && seen.torque_enabled) orderOff();
  channel_.observe(seen, dt);
  encoder_watch_.update(seen, push(seen), dt);
}

void JointGuard::resetTrip() noexcept {
  trip_ = Trip::kNone;
  trip_watch_.forget();
}

void JointGuard::engage(bool wanted) noexcept {
  if (!wanted || never_driven_ || limp_ || trip_ != Trip::kNone)
    channel_.leaveOut();
  else if (channel_.out())
    channel_.restart();
}

void JointGuard::restart() noexcept {
  if (!channel_.out()) channel_.restart();
}

void JointGuard::switchTorque(bool on) noexcept {
  if (off_due_) {
    // Earlier polls are obsolete. A servo that missed a command counts as stiff until a poll shows otherwise.
    if (!off_ordered_) stiff_ = torque_known_ = false;
    off_due_ = false;
    off_ordered_ = true;
  }
  if (!on || !onDue()) return;
  channel_.torqueOn();
  on_seen_ = false;
}

}  // namespace darwinop::safety
