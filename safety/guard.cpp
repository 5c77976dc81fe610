// One cycle of the safety layer: read commands, monitor sensors, update faults and state, compose safe commands.
#include "safety/guard.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "safety/session_settings.hpp"
#include "safety/start_pose.hpp"

namespace darwinop::safety {
namespace {

template <std::size_t... I>
std::array<JointGuard, kJoints> makeJoints(const Config& config, std::index_sequence<I...>) {
  return {JointGuard{static_cast<Joint>(I), config}...};
}

const Config& checked(const Config& config) {
  config.check();
  return config;
}

LedCommand limitLed(LedCommand led) noexcept {
  led.panel &= 7;
  led.head &= 0x7FFF;
  led.eye &= 0x7FFF;
  return led;
}

}  // namespace

Guard::Guard(const Config& config)
    : robot_config_{checked(config)},
      config_{robot_config_},
      start_pose_{startPose(config_)},
      driver_{config_},
      board_{config_},
      faults_{config_},
      joints_{makeJoints(config_, std::make_index_sequence<kJoints>{})},
      move_{config_} {
  reportSettings();
}

SafeCommands Guard::vet(const Commands& asked, const Sensors& seen) noexcept {
  // The nominal period, not elapsed time: the first step after an overrun is no longer than any other.
  const Nanos dt = seen.period_ns > 0 ? Nanos{seen.period_ns} : config_.period;
  take(asked, dt);
  watch(seen, dt);
  noteFaults();
  changeState(seen, dt);
  for (JointGuard& joint : joints_) joint.engage(drives(state_) && board_.powered());
  SafeCommands safe = compose(dt);
  if (board_.absent() && safe.write_ == SafeCommands::Write::kGoals) board_.noteGoals(safe.driven_ & ~safe.skipped_);
  if (board_.online()) safe.led_ = limitLed(asked.led);
  safe.power_on_ = board_.wantsPower();
  writeReport();
  return safe;
}

void Guard::take(const Commands& asked, Nanos dt) noexcept {
  driver_.update(asked, excusesSilence(), dt);
  if (driver_.came()) beginSession(asked);
  if (asked.loop_ends) config_.on_exit = robot_config_.on_exit;
  if (driver_.resetAsked()) clearFaults();
  if (!driver_.obeyed()) return;
  holds_only_ = asked.hold;
  if (holds_only_ && state_ == State::kLimp && allKnown() && !anyStiff()) driver_.end();
  for (std::size_t i = 0; i < kJoints; ++i) joints_[i].take(asked.joint[i], report_.limit_hits);
}

void Guard::beginSession(const Commands& asked) noexcept {
  config_ = tightened(robot_config_, asked.settings);
  start_pose_ = startPose(config_);
  in_place_ = asked.start_where_it_is || config_.start == StartMove::kHold;
  started_ = false;
  report_.missed_start.reset();
  for (JointGuard& joint : joints_) joint.forgetRequests();
  reportSettings();
}

void Guard::reportSettings() noexcept {
  report_.gentle_speed = static_cast<float>(config_.gentle_speed);
  report_.default_p_gain = static_cast<float>(config_.default_p_gain);
  report_.default_speed = static_cast<float>(config_.default_speed);
  report_.at_end = atExit(config_.on_exit);
}

/// Called when a person has acted.
void Guard::clearFaults() noexcept {
  faults_.reset();
  board_.allowPower();
  for (JointGuard& joint : joints_) joint.resetTrip();
}

void Guard::watch(const Sensors& seen, Nanos dt) noexcept {
  // While power is withheld nothing can move in any state: a session may have begun since.
  const bool released = latchedFault(faults_.all()) != Fault::kNone && !drives(state_);
  board_.update(seen, released || board_.powerWithheld(), dt);
  if (board_.startPressed()) clearFaults();
  for (std::size_t i = 0; i < kJoints; ++i) joints_[i].observe(seen.joint[i], seen.silent[i], board_.poweredFor(), dt);
  watchHold();
  // Without a board an outage may have been one of the supply: only polls after it show who has torque.
  const bool unseen = board_.absent() && !board_.online();
  if (!board_.powerLost() && !unseen) return;
  if (!unseen) holding_up_ = false;
  for (JointGuard& joint : joints_) joint.forgetTorque();
}

/// Pressing RESET releases the robot. It counts as a fault if joints may have been held when power was lost: a torque
/// off just sent may not have arrived, and a robot that was not polled yet may be stiff. Servo power that is off from
/// the start, on a robot that no loop has held, only means that the board was just switched on.
void Guard::watchHold() noexcept {
  const bool held = drives(state_) || state_ == State::kFoundStiff || holding_up_ || perhaps_held_;
  lost_under_torque_ = board_.powerLostNow() && held;
  // Silent servos count as polled, but only after enough time for a reply.
  const auto seen_limp = [this] {
    return board_.poweredFor() >= fromSeconds(config_.silent_s) && allKnown() && !anyStiff();
  };
  if (board_.powerOff() || (perhaps_held_ && seen_limp())) perhaps_held_ = false;
}

void Guard::noteFaults() noexcept {
  FaultCauses causes;
  causes.note(Fault::kBusSilent, board_.silent());
  causes.note(Fault::kBoardReset, lost_under_torque_);
  causes.note(Fault::kServoPowerOff, board_.powerLost());
  causes.note(Fault::kBatteryLow, board_.batteryLow());
  causes.note(Fault::kBatteryEmpty, board_.batteryEmpty());
  causes.note(Fault::kFell, board_.fell());
  causes.note(Fault::kReleasedByButton, board_.released());
  causes.note(Fault::kReleasedByOperator, driver_.released());
  causes.note(Fault::kControllerStalled, driver_.stalled());
  causes.note(Fault::kControllerGone, driver_.gone());
  report_.tripped.reset();
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (joints_[i].well()) continue;
    causes.note(joints_[i].faults(), kJointTable[i].id);
    report_.tripped[i] = joints_[i].trip() != JointGuard::Trip::kNone;
  }
  forEachJoint(report_.missed_start,
               [&](std::size_t i) { causes.note(faultIf(true, Fault::kStartMissed), kJointTable[i].id); });
  faults_.update(causes);
}

inline Rad Guard::target(std::size_t joint) const noexcept {
  switch (state_) {
    case State::kStarting:
    case State::kKneeling:
      return start_pose_[joint];
    case State::kDriven:
      return joints_[joint].requestedGoal();
    case State::kTakingOver:
    case State::kHolding:
    case State::kOffline:
    case State::kLimp:
    case State::kFoundStiff:
    case State::kCount:
      return Rad{};
  }
  return Rad{};
}

/// Fraction of the full step for each joint. In a move to a pose the joint with the longest distance sets the pace and
/// all arrive together: hips, knees and ankles of a standing robot bend in proportion, and its feet stay flat.
inline Guard::Shares Guard::shares() const noexcept {
  Shares shares;
  shares.fill(1.0);
  if (!movesByItself()) return shares;
  Shares way{};
  for (std::size_t i = 0; i < kJoints; ++i)
    if (joints_[i].channel().moving()) way[i] = std::abs(target(i).value - joints_[i].channel().goal().value);
  const double furthest = std::ranges::max(way);
  for (std::size_t i = 0; i < kJoints; ++i)
    if (furthest > 0) shares[i] = way[i] / furthest;
  return shares;
}

inline void Guard::moveJoints(double speed, Nanos dt) noexcept {
  const double seconds = std::chrono::duration<double>(dt).count();
  const double gentle_step = config_.gentle_speed * seconds, full_step = speed * seconds;
  const Shares share = shares();
  std::uint32_t cut_short = 0;
  for (std::size_t i = 0; i < kJoints; ++i)
    if (!joints_[i].move(target(i), share[i] * gentle_step, share[i] * full_step)) ++cut_short;
  if (state_ == State::kDriven) report_.limit_hits[static_cast<std::size_t>(Limit::kRate)] += cut_short;
}

SafeCommands Guard::compose(Nanos dt) noexcept {
  SafeCommands safe;
  if (state_ == State::kOffline) return safe;
  // A board that did not reply may not have received the last goals either. Goals do not advance until it replies, so
  // that the next goals received are one step from the last ones. Nothing is written meanwhile: a servo may have
  // restarted.
  const bool answers = board_.answersNow();
  // For the same reason torque is switched on only after a goal was received; torque off is always sent.
  safe.torque_off_ = jointsThat([this](std::size_t i) { return joints_[i].offDue(); });
  if (answers) safe.torque_on_ = jointsThat(polling_, [this](std::size_t i) { return joints_[i].onDue(); });
  const bool switches = (safe.torque_off_ | safe.torque_on_).any();
  const bool by_itself = movesByItself();
  const bool slow = by_itself || faults_.slow();
  const double speed = slow ? config_.gentle_speed : config_.max_joint_speed;
  if (switches)
    for (JointGuard& joint : joints_) joint.switchTorque(answers);
  else if (answers)
    moveJoints(speed, dt);
  safe.driven_ = jointsThat([this](std::size_t i) { return joints_[i].driven(); });
  const auto unsettled = jointsThat([this](std::size_t i) { return joints_[i].pollDue() || joints_[i].uncertain(); });
  safe.poll_ = polling_ = jointsThat(unsettled, [this](std::size_t i) { return joints_[i].pollDue(); });
  safe.skipped_ = safe.driven_;
  if (answers) safe.skipped_ &= jointsThat(unsettled, [this](std::size_t i) { return joints_[i].uncertain(); });
  forEachJoint(safe.driven_, [&](std::size_t i) { safe.goal_[i] = joints_[i].goal(RadPerSec{speed}, by_itself); });
  if (switches)
    safe.write_ = SafeCommands::Write::kTorque;
  else if (safe.driven_.any())
    safe.write_ = SafeCommands::Write::kGoals;
  if (safe.driven_.any()) holding_up_ = true;
  return safe;
}

void Guard::writeReport() noexcept {
  report_.state = state_;
  report_.active = faults_.all();
  report_.worst = faults_.worst();
  report_.worst_joint = faults_.servo(report_.worst);
  report_.reaction = faults_.reaction(report_.worst);
  report_.controller_must_end = faults_.endsController();
  report_.session = driver_.session();
}

}  // namespace darwinop::safety
