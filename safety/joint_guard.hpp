// Safety of one joint: requests of the controller, health of the servo, takeover and motion.
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
  /// Causes of faults, from the reading of the previous cycle.
  [[nodiscard]] FaultSet faults() const noexcept;
  /// True if faults() is empty. Branch-free: called for every joint in every cycle.
  [[nodiscard]] bool well() const noexcept {
    const int problems = int{watch_.silent()} | watch_.hot() | watch_.overheated() | watch_.badVoltage() |
                         unresponsive() | encoder_watch_.stuck() | (trip_ != Trip::kNone);
    return problems == 0;
  }
  [[nodiscard]] Trip trip() const noexcept { return trip_; }
  /// As far as is known the servo has torque, regardless of which process switched it on.
  [[nodiscard]] bool stiff() const noexcept { return stiff_; }
  /// The servo was polled since it replies; or it does not reply, and its torque cannot be known; or there is none.
  [[nodiscard]] bool torqueKnown() const noexcept { return absent_ || torque_known_ || watch_.lost(); }
  /// Servo power is off, and with it the torque; or may have been.
  void forgetTorque() noexcept { stiff_ = torque_known_ = false; }
  /// Requested reset: a servo that shut itself off may be driven again.
  void resetTrip() noexcept;

  // -- how it is driven
  /// `wanted`: the robot's state is one in which joints are driven, and servos have power.
  void engage(bool wanted) noexcept;
  void restart() noexcept;
  void orderOff() noexcept { off_due_ = !no_writes_; }
  [[nodiscard]] bool offDue() const noexcept { return off_due_; }
  /// Torque off was sent since torque was last switched on, or may not be sent.
  [[nodiscard]] bool offOrdered() const noexcept { return off_ordered_ || no_writes_; }
  /// The servo must be polled in this cycle: torque is switched on after a poll shows the placed goal, and the goal
  /// stays until a poll shows torque. A SyncWrite is not acknowledged, and a goal write switches torque on.
  [[nodiscard]] bool pollDue() const noexcept { return channel_.placed() || (channel_.moving() && !on_seen_); }
  /// Torque may be switched on: a poll in the previous cycle showed the placed goal and a gentle speed. With an older
  /// goal the joint would jump.
  [[nodiscard]] bool onDue() const noexcept { return channel_.placed() && has_goal_ && !suspected_; }
  [[nodiscard]] const JointChannel& channel() const noexcept { return channel_; }
  /// Has a goal, and gets the next one in this cycle unless uncertain().
  [[nodiscard]] bool driven() const noexcept { return channel_.hasGoal() && !suspected_; }
  /// The servo missed a reply and was not polled since. It may have restarted; a goal would then switch its torque on
  /// at an unknown position and without a speed limit.
  [[nodiscard]] bool uncertain() const noexcept { return uncertain_; }
  [[nodiscard]] Rad requestedGoal() const noexcept { return requested_goal_; }

  /// This cycle's write switches torque: marks pending torque off, and with `on` also torque on, as sent.
  void switchTorque(bool on) noexcept;
  /// This cycle's write carries goals: places the joint, or moves it towards `target` (unknown: no move). False if the
  /// step limit applied.
  bool move(Rad target, double gentle_step, double full_step) noexcept {
    if (suspected_) return true;  // nothing is written to it in this cycle
    if (channel_.ready()) {
      place();
      return true;
    }
    if (uncertain_ || !on_seen_ || !channel_.moving() || !target.known()) return true;
    return channel_.advance(target, gentle_step, full_step);
  }
  /// The command to send. `speed_cap`: maximum speed. `by_itself`: safety moves the robot; requested speed, torque and
  /// gain are ignored.
  [[nodiscard]] SafeCommands::JointGoal goal(RadPerSec speed_cap, bool by_itself) const noexcept {
    const double cap = channel_.gentle() ? std::min(config_.gentle_speed, speed_cap.value) : speed_cap.value;
    if (by_itself)
      return {channel_.goal(), RadPerSec{cap}, NewtonMeter{config_.default_torque}, config_.default_p_gain};
    return {channel_.goal(), RadPerSec{std::min(requested_speed_.value, cap)}, requested_torque_, requested_p_gain_};
  }

 private:
  // Lost writes are rare. An attempt takes three cycles and is harmless; all of them take about a second.
  static constexpr int kRefusals = 20;

  /// The servo replies, but its registers repeatedly lack what was written.
  [[nodiscard]] bool unresponsive() const noexcept { return refused_ >= kRefusals; }
  void takeSettings(const JointCommand& asked, LimitHits& hits) noexcept;
  void takeTorqueRequest(bool on) noexcept;
  void place() noexcept {
    channel_.place(range());
    uncertain_ = false;  // this goal is written with all settings
    off_ordered_ = false;
  }
  void noteRestart(const JointSensors& seen) noexcept;
  void notePlaced(const JointSensors& seen) noexcept;
  [[nodiscard]] double push(const JointSensors& seen) const noexcept;
  [[nodiscard]] const JointRange& range() const noexcept { return config_.range[index(joint_)]; }

  const Config& config_;
  Joint joint_;
  bool absent_, no_writes_, never_driven_;
  Rad requested_goal_;  // unknown: none yet
  RadPerSec requested_speed_;
  NewtonMeter requested_torque_;
  double requested_p_gain_ = 0;
  bool stiff_ = false, torque_known_ = false;
  bool limp_ = false;  // the controller switched torque off

  ServoWatch watch_;
  TripWatch trip_watch_;
  EncoderWatch encoder_watch_;
  JointChannel channel_;
  Trip trip_ = Trip::kNone;
  bool suspected_ = false, uncertain_ = false;
  bool has_goal_ = false;      // a poll in the previous cycle found it in the servo
  bool on_seen_ = false;       // a poll found torque on since it was switched on
  bool shut_at_once_ = false;  // torque limit was 0 when the placed goal was seen
  bool had_limit_ = false;     // had a speed limit at its last poll
  int refused_ = 0;            // placed goals in a row that were not in the servo when polled
  bool off_due_ = false;       // torque off must be sent
  bool off_ordered_ = false;   // torque off was sent; if a poll finds torque on, the write was lost
};

}  // namespace darwinop::safety
