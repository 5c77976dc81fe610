// Protection of one joint: the controller's requests, the servo's health, how it is driven.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/commands.hpp"
#include "core/safe_commands.hpp"
#include "core/sensors.hpp"
#include "safety/config.hpp"
#include "safety/encoder_watch.hpp"
#include "safety/fault_book.hpp"
#include "safety/joint_channel.hpp"
#include "safety/joint_limiter.hpp"
#include "safety/servo_watch.hpp"
#include "safety/trip_watch.hpp"

namespace darwinop::safety {

class JointGuard {
 public:
  enum class Trip : std::uint8_t { kNone, kOverload, kOverheat };

  JointGuard(Joint joint, const Config& config);

  // -- requests of the controller
  /// A new driver starts without the requests of the previous one.
  void forgetRequests() noexcept;
  void take(const JointCommand& asked, LimitHits& hits) noexcept {
    if (asked.has(JointCommand::kGoal)) requested_goal_ = limitGoal(asked.goal, requested_goal_, range(), hits);
    if ((asked.set & ~JointCommand::kGoal) != 0) takeSettings(asked, hits);
  }
  /// Goal of the joint until the controller requests one.
  void requestIfNone(Rad goal) noexcept;

  // -- reports of the servo
  void observe(const JointSensors& seen, bool given_up, Nanos powered_for, Nanos dt) noexcept;
  /// The causes of faults, by the reading of the cycle before.
  [[nodiscard]] FaultSet faults() const noexcept;
  /// No faults(). Without a branch for each of them: this is asked of every joint in every cycle.
  [[nodiscard]] bool well() const noexcept {
    const int problems = int{watch_.silent()} | watch_.hot() | watch_.overheated() | watch_.badVoltage() |
                         unresponsive() | encoder_watch_.stuck() | (trip_ != Trip::kNone);
    return problems == 0;
  }
  [[nodiscard]] Trip trip() const noexcept { return trip_; }
  /// As far as is known the servo holds its joint, on any request.
  [[nodiscard]] bool stiff() const noexcept { return stiff_; }
  /// It was polled since it answers, or it does not answer, and its torque cannot be known.
  [[nodiscard]] bool torqueKnown() const noexcept { return torque_known_ || watch_.lost(); }
  /// Servo power is off, and with it its torque.
  void losePower() noexcept { stiff_ = torque_known_ = false; }
  /// Asked for: a servo that shut itself off may be driven again.
  void resetTrip() noexcept;

  // -- how it is driven
  /// `wanted`: the state of the robot is one in which joints are driven, and servos have power.
  void engage(bool wanted) noexcept;
  void restart() noexcept;
  void orderOff() noexcept { off_due_ = !absent_; }
  [[nodiscard]] bool offDue() const noexcept { return off_due_; }
  /// Torque off was sent since torque was last switched on here.
  [[nodiscard]] bool offOrdered() const noexcept { return off_ordered_; }
  /// Its servo is polled in every cycle: torque waits for the placed goal to be seen, and the goal stays in its
  /// place until torque is seen. A SyncWrite is not acknowledged, and a goal write switches torque on.
  [[nodiscard]] bool pollDue() const noexcept { return channel_.placed() || (channel_.moving() && !on_seen_); }
  /// A poll in the cycle before found the placed goal and a gentle speed: torque must not find an older goal.
  [[nodiscard]] bool onDue() const noexcept { return channel_.placed() && has_goal_ && !suspected_; }
  [[nodiscard]] const JointChannel& channel() const noexcept { return channel_; }
  /// Has a goal, and gets the next one in this cycle unless it is uncertain().
  [[nodiscard]] bool driven() const noexcept { return channel_.hasGoal() && !suspected_; }
  /// It has missed an answer and was not polled since: it may have restarted, and then a goal would switch its
  /// torque on, wherever it is by now and without a speed limit.
  [[nodiscard]] bool uncertain() const noexcept { return uncertain_; }
  [[nodiscard]] Rad requestedGoal() const noexcept { return requested_goal_; }

  /// This cycle's write carries torque switches: takes the orders that are due; `on`: also those to switch on.
  void switchTorque(bool on) noexcept;
  /// This cycle's write carries goals: places the joint, or moves it towards `target` (unknown: stays).
  /// False when the step was cut short.
  bool move(Rad target, double gentle_step, double full_step) noexcept {
    if (suspected_) return true;  // nothing of it is written in this cycle
    if (channel_.ready()) {
      place();
      return true;
    }
    if (uncertain_ || !on_seen_ || !channel_.moving() || !target.known()) return true;
    return channel_.advance(target, gentle_step, full_step);
  }
  /// What goes on the wire. `speed_cap`: no faster than this.
  /// `by_itself`: safety moves the robot, and the requested speed, torque and gain do not count.
  [[nodiscard]] SafeCommands::JointGoal goal(RadPerSec speed_cap, bool by_itself) const noexcept {
    const double cap = channel_.gentle() ? std::min(config_.gentle_speed, speed_cap.value) : speed_cap.value;
    if (by_itself)
      return {channel_.goal(), RadPerSec{cap}, NewtonMeter{config_.default_torque}, config_.default_p_gain};
    return {channel_.goal(), RadPerSec{std::min(requested_speed_.value, cap)}, requested_torque_, requested_p_gain_};
  }

 private:
  // A lost write is rare; each try takes three cycles and does no harm, so all of them about a second.
  static constexpr int kRefusals = 20;

  /// It answers, and again and again it is seen without what was written to it.
  [[nodiscard]] bool unresponsive() const noexcept { return refused_ >= kRefusals; }
  void takeSettings(const JointCommand& asked, LimitHits& hits) noexcept;
  void takeTorqueRequest(bool on) noexcept;
  void place() noexcept {
    channel_.place(range());
    uncertain_ = false;  // all it needs is written with this goal
    off_ordered_ = false;
  }
  void noteRestart(const JointSensors& seen) noexcept;
  void notePlaced(const JointSensors& seen) noexcept;
  [[nodiscard]] double push(const JointSensors& seen) const noexcept;
  [[nodiscard]] const JointRange& range() const noexcept { return config_.range[index(joint_)]; }

  const Config& config_;
  Joint joint_;
  bool absent_, never_driven_;
  Rad requested_goal_;  // unknown: none yet
  RadPerSec requested_speed_;
  NewtonMeter requested_torque_;
  double requested_p_gain_ = 0;
  bool stiff_ = false, torque_known_ = false;
  bool limp_ = false;  // the controller has switched its torque off

  ServoWatch watch_;
  TripWatch trip_watch_;
  EncoderWatch encoder_watch_;
  JointChannel channel_;
  Trip trip_ = Trip::kNone;
  bool suspected_ = false, uncertain_ = false;
  bool has_goal_ = false;      // a poll in the cycle before found it in the servo
  bool on_seen_ = false;       // a poll has found torque on since it was switched on
  bool shut_at_once_ = false;  // off again when it was seen with it
  bool had_limit_ = false;     // of its speed, when it was polled last
  int refused_ = 0;            // placed goals in a row that the servo was seen without
  bool off_due_ = false;       // torque off has to be sent
  bool off_ordered_ = false;   // it was; a poll that says otherwise means that the write was lost
};

}  // namespace darwinop::safety
