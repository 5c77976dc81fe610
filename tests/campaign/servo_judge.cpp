// The promises, one function each.
#include "campaign/servo_judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/conversions.hpp"
#include "core/registers.hpp"

namespace darwinop {
namespace {

constexpr int kPatience = 5;  // unanswered requests in a row that must not count as a lost board; docs/faults.md 10
constexpr auto kNear = boundAs<int>(Leniency::kNearJoint);
constexpr auto kHeldCycles = boundAs<int>(Leniency::kShortPress);
constexpr auto kLimpAfter = boundAs<int>(Leniency::kStillStiff);
constexpr auto kForgotten = boundAs<int>(Leniency::kUnseenRestart);
constexpr auto kLate = boundAs<int>(Leniency::kLateWrite);
constexpr auto kGrace = boundAs<int>(Leniency::kEarlyBit);
constexpr auto kEarlyTrips = boundAs<int>(Leniency::kEarlyTrips);
constexpr auto kUnlimitedRound = boundAs<int>(Leniency::kNoSpeedLimit);
constexpr auto kUntrustedFor = boundAs<int>(Leniency::kUntrusted);
constexpr std::uint8_t kModeButton = 1, kStartButton = 2;

bool carriesGoal(std::uint8_t address, std::size_t size) {
  return address <= servo::kGoalPosition && address + size >= servo::kGoalPosition + 2U;
}

int goalIn(Bytes data, std::uint8_t address) {
  const std::size_t at = std::size_t{servo::kGoalPosition} - address;
  return data[at] | data[at + 1] << 8;
}

}  // namespace

ServoJudge::ServoJudge(hil::VirtualRobot& robot, const safety::Config& config)
    : robot_{robot},
      config_{config},
      max_step_{config.max_joint_speed * std::chrono::duration<double>(config.period).count() / kRadPerTick +
                bound(Leniency::kRounding)} {
  robot_.board().observe(this);
  for (std::size_t i = 0; i < kJoints; ++i) servo_[i].position.fill(truth(static_cast<Joint>(i)));
}

void ServoJudge::beginCycle(const Commands& asked) {
  ++cycle_;
  bulk_reads_ = 0;
  port_closed_ = !robot_.portOpen();
  if (port_closed_ || replugs_ != robot_.replugs()) port_lost_at_ = cycle_;
  replugs_ = robot_.replugs();
  const bool by_controller = asked.session != session_ || asked.fault_resets != resets_;
  const bool try_again = (by_controller && !asked.unattended) || asked.operator_resets != operator_resets_;
  session_ = asked.session;
  resets_ = asked.fault_resets;
  operator_resets_ = asked.operator_resets;
  if (try_again) personActs();
  if (asked.operator_releases != operator_releases_) release();
  operator_releases_ = asked.operator_releases;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointCommand& joint = asked.joint[i];
    if (joint.has(JointCommand::kTorque) && joint.torque_on) servo_[i].trips = servo_[i].early_trips = 0;
    if (robot_.board().hasTwin(static_cast<Joint>(i))) servo_[i].untrusted_until = cycle_ + kUntrustedFor;
  }
}

void ServoJudge::endCycle(const Sensors& seen) {
  judgeOutage(seen);
  notePerson(seen);
  for (std::size_t i = 0; i < kJoints; ++i) {
    Servo& servo = servo_[i];
    servo.position[static_cast<std::size_t>(cycle_) % kPositionWindow] = truth(static_cast<Joint>(i));
    const bool fresh = seen.joint[i].motion.fresh();
    if (fresh != (servo.silent == 0)) note(static_cast<Joint>(i), fresh ? "answers" : "does not answer");
    const bool driven = seen.joint[i].driven;
    if (driven != servo.driven) note(static_cast<Joint>(i), driven ? "driven" : "not driven");
    if (driven && !servo.driven) servo.driven_since = cycle_;
    servo.driven = driven;
    servo.silent = fresh ? 0 : servo.silent + 1;
    if (fresh) servo.late_goals = 0;
    servo.answered = fresh ? servo.answered + 1 : 0;
    if (seen.safety.tripped[i] || servo.silent >= kForgotten) servo.trips = servo.early_trips = 0;
  }
  judgeLimp(seen);
  judgeSpeedLimits(seen);
  state_ = seen.safety.state;
}

/// Up to five unanswered requests in a row are noise. Cycles in which nothing was asked are not misses.
void ServoJudge::judgeOutage(const Sensors& seen) {
  if (seen.safety.state == State::kOffline && state_ != State::kOffline) {
    ++tally_.outages;
    if (missed_answers_ <= kPatience)
      blame(Promise::kPatience, "offline after " + std::to_string(missed_answers_) + " missed answers");
  }
  const bool asked = bulk_reads_ > 0 || port_closed_ || !robot_.portOpen();
  if (seen.bus.fresh())
    missed_answers_ = 0;
  else if (asked)
    ++missed_answers_;
}

void ServoJudge::release() {
  if (!released_) ++tally_.releases;
  released_ = true;
}

void ServoJudge::personActs() {
  for (Servo& servo : servo_) servo.trips = servo.early_trips = 0;
  if (mode_held_ < kHeldCycles - 1) released_ = false;  // while MODE is held it counts again at once
}

/// MODE and RESET are how a person releases the robot. START, pressed while it is at rest, takes that back.
void ServoJudge::notePerson(const Sensors& seen) {
  if (!seen.board.motion.fresh()) return;
  const bool mode = (seen.board.buttons & kModeButton) != 0;
  if (!mode && mode_held_ > 0 && mode_held_ < kHeldCycles) tolerate(Leniency::kShortPress);
  mode_held_ = mode ? mode_held_ + 1 : 0;
  if (mode_held_ == kHeldCycles) release();

  power_off_seen_ = seen.board.servo_power ? 0 : power_off_seen_ + 1;
  if (power_off_seen_ == 2 && lost_under_torque_) release();
  if (seen.board.servo_power) lost_under_torque_ = false;

  const bool at_rest = !drives(state_);
  const bool start = (seen.board.buttons & kStartButton) != 0;
  start_held_ = start && (start_held_ > 0 || at_rest) ? start_held_ + 1 : 0;
  if (start_held_ == kHeldCycles - 1) personActs();
}

/// "limp" means that no servo that answers holds its joint.
void ServoJudge::judgeLimp(const Sensors& seen) {
  limp_for_ = seen.safety.state == State::kLimp ? limp_for_ + 1 : 0;
  if (limp_for_ == 0) return;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    if (limp_for_ < kLimpAfter) {
      if (robot_.board().servo(joint).state().pulls()) tolerate(Leniency::kStillStiff);
      continue;
    }
    if (servo_[i].answered < kLimpAfter || servo_[i].untrusted_until > cycle_) continue;
    ++tally_.limp_looks;
    if (robot_.board().servo(joint).state().pulls())
      blame(Promise::kLimp, joint, "under torque in a robot that is called limp");
  }
}

/// Torque that a late goal or a short restart left without a speed limit is noticed at the next poll. A servo that says
/// that it has shut itself off gets no goal any more: one that has not stays where its last goal is.
void ServoJudge::judgeSpeedLimits(const Sensors& seen) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    Servo& servo = servo_[i];
    const auto joint = static_cast<Joint>(i);
    const hil::ServoState now = robot_.board().servo(joint).state();
    const bool unlimited = now.pulls() && now.speed == 0 && servo.silent == 0 && !seen.safety.tripped[i] &&
                           servo.untrusted_until <= cycle_;
    servo.unlimited_for = unlimited ? servo.unlimited_for + 1 : 0;
    if (unlimited) tolerate(Leniency::kNoSpeedLimit);
    if (servo.unlimited_for > kUnlimitedRound)
      blame(Promise::kSpeedLimit, joint, "for long under torque without a speed limit");
  }
}

void ServoJudge::request(const Frame& frame, Nanos /*at*/) noexcept {
  if (frame.code == static_cast<std::uint8_t>(Instruction::kBulkRead)) ++bulk_reads_;
  if (frame.code != static_cast<std::uint8_t>(Instruction::kSyncWrite) || frame.params.size() < 2) return;
  const std::uint8_t address = frame.params[0], size = frame.params[1];
  for (Bytes rest = frame.params.subspan(2); rest.size() > size; rest = rest.subspan(size + 1U)) {
    const std::size_t joint = rest[0] - std::size_t{1};
    if (joint >= kJoints || size > Sent{}.data.size()) continue;
    Servo& servo = servo_[joint];
    if (address == servo::kTorqueLimit) {  // its goal may wait for a cycle
      ++servo.waits;
      servo.limit_sent_at = cycle_;
    }
    if (carriesGoal(address, size)) {
      servo.goals_sent += 1 + servo.waits - (servo.limit_sent_at == cycle_ ? 1 : 0);
      servo.waits = 0;
    }
    Sent& sent = servo.sent[servo.sent_count++ % kSentRoom];
    sent = {cycle_, servo.goals_sent, address, size, {}, false};
    std::ranges::copy(rest.subspan(1, size), sent.data.begin());
    if (carriesGoal(address, size))
      sent.at_joint = nearJoint(static_cast<Joint>(joint), goalIn(rest.subspan(1, size), address));
  }
}

/// The newest write that may be this one: not older than the last that came through.
const ServoJudge::Sent* ServoJudge::findSent(Servo& servo, std::uint8_t address, Bytes data) const {
  const std::uint32_t oldest = servo.sent_count > kSentRoom ? servo.sent_count - kSentRoom : 0;
  for (std::uint32_t number = servo.sent_count; number-- > std::max(oldest, servo.arrived);) {
    const Sent& sent = servo.sent[number % kSentRoom];
    if (sent.address != address || !std::ranges::equal(Bytes{sent.data}.first(sent.size), data)) continue;
    servo.arrived = number;
    return &sent;
  }
  return nullptr;
}

void ServoJudge::written(Joint joint, std::uint8_t address, Bytes data, const hil::ServoState& before,
                         const hil::ServoState& after) noexcept {
  Servo& servo = servo_[index(joint)];
  const Sent* sent = findSent(servo, address, data);
  if (sent == nullptr) {
    ++tally_.damaged;
    tolerate(Leniency::kUntrusted);
    note(joint, "damaged write");
    servo.untrusted_until = cycle_ + kUntrustedFor;
    return;
  }
  note(joint, address == servo::kTorqueEnable   ? "torque written"
              : address == servo::kGoalPosition ? "goal written"
              : address == servo::kTorqueLimit  ? "torque limit written"
              : address == servo::kLock         ? "lock written"
                                                : "goal and settings written");
  // A goal that went into a cable that was out is one that nobody saw; the next one waits for an answer.
  const bool in_cable = port_lost_at_ >= servo.goal_at - 1;
  const std::uint32_t goals =
      sent->goals - servo.goals_arrived + (in_cable ? boundAs<std::uint32_t>(Leniency::kGoalInCable) : 0);
  const bool with_goal = carriesGoal(address, data.size());
  const bool repeated = sent->goals == servo.goals_arrived;  // by the line
  if (with_goal) {
    servo.goal_at = cycle_;
    servo.goals_arrived = sent->goals;
  }
  if (address == servo::kTorqueLimit && before.torque_limit == 0) noteErasedTrip(joint);
  const bool late = sent->cycle < servo.powered_at || cycle_ - sent->cycle > kLate;
  const bool edge = !before.pulls() && after.pulls();
  if (edge) servo.pulls_since = cycle_;
  if (address == servo::kTorqueEnable && after.torque_enable) servo.torque_on_at = cycle_;
  // Also if the edge itself is not judged.
  if (edge && cycle_ - servo.lost_at <= kForgotten) servo.unlimited_until = cycle_ + kUnlimitedRound;
  if (servo.untrusted_until > cycle_) return tolerate(Leniency::kUntrusted);
  if (late && with_goal && !repeated) judgeLate(joint, *sent, before, after, goals);
  if (late) return tolerate(Leniency::kLateWrite);
  if (edge) judgeEdge(joint, after, goals);
  if (servo.untrusted_until > cycle_) return;
  // Other writes neither switch torque on nor move the joint: judgeSpeedLimits().
  const bool drives = with_goal || address == servo::kTorqueEnable;
  if (drives && after.pulls() && after.speed == 0 && cycle_ > servo.unlimited_until)
    blame(Promise::kSpeedLimit, joint, "under torque without a speed limit");
  if (before.pulls() && after.goal != before.goal) judgeStep(joint, before, after, goals);
}

void ServoJudge::judgeEdge(Joint joint, const hil::ServoState& after, std::uint32_t goals) {
  ++tally_.edges;
  const int gentle = registerFromSpeedLimit(RadPerSec{config_.gentle_speed});
  if (released_) blame(Promise::kRelease, joint, "torque came on after a person released the robot");
  if (judgeShortOutage(joint, after, goals) || undoesUnseenTrip(joint)) return;
  if (!acceptsGoal(joint, after.goal))
    blame(Promise::kGoalAtJoint, joint,
          "torque came on with the goal " + std::to_string(after.goal - truth(joint)) + " ticks away");
  if (after.speed == 0 || after.speed > gentle)
    blame(Promise::kGentleStart, joint, "torque came on with speed register " + std::to_string(after.speed));
}

/// A stalled board carries out a write after the servo has restarted, and it cannot be called back. There is one goal
/// at most on its way, because the next one waits for an answer. One that takes the joint over goes to where it was, at
/// the gentle speed: a servo that still has torque of before returns from where that has moved it.
void ServoJudge::judgeLate(Joint joint, const Sent& sent, const hil::ServoState& before, const hil::ServoState& after,
                           std::uint32_t goals) {
  ++tally_.late;
  tolerate(Leniency::kLateGoal);
  if (++servo_[index(joint)].late_goals > boundAs<int>(Leniency::kLateGoal))
    blame(Promise::kStep, joint, "more than one goal carried out late");
  const int gentle = registerFromSpeedLimit(RadPerSec{config_.gentle_speed});
  if (sent.at_joint && after.speed > 0 && after.speed <= gentle) return;
  if (before.pulls() && after.goal != before.goal) judgeStep(joint, before, after, goals);
}

/// A servo that restarts within a few cycles may not even miss an answer: its goal goes on from where it was, one step
/// for each goal that was sent, and that it has lost its settings is seen when its turn to be polled comes.
bool ServoJudge::judgeShortOutage(Joint joint, const hil::ServoState& after, std::uint32_t goals) {
  const Servo& servo = servo_[index(joint)];
  const long cycles = cycle_ - servo.lost_at;
  if (cycles > kForgotten) return false;
  tolerate(Leniency::kUnseenRestart);
  const int step = std::abs(after.goal - servo.lost_goal);
  const long steps = std::max<long>(goals, cycles + 1);
  if (step <= max_step_ * static_cast<double>(steps) || acceptsGoal(joint, after.goal)) return true;
  blame(Promise::kStep, joint, "goal moved by " + std::to_string(step) + " ticks in a short outage");
  return true;
}

/// A servo that shuts itself off between its answer and the next write, which carries a new torque limit: the write
/// cannot know. Its goal goes on from a moment ago.
bool ServoJudge::undoesUnseenTrip(Joint joint) {
  if (cycle_ - servo_[index(joint)].tripped_at > boundAs<int>(Leniency::kBlindTrip)) return false;
  ++tally_.blind;
  tolerate(Leniency::kBlindTrip);
  --servo_[index(joint)].trips;
  return true;
}

/// A limit that is written alone just after a shutdown erases what distinguishes it from a restart. Torque stays off
/// until the joint is taken over.
void ServoJudge::noteErasedTrip(Joint joint) {
  Servo& servo = servo_[index(joint)];
  if (cycle_ - servo.tripped_at > boundAs<int>(Leniency::kBlindTrip) || servo.trips == 0) return;
  ++tally_.blind;
  tolerate(Leniency::kBlindTrip);
  --servo.trips;
  if (++servo.early_trips > kEarlyTrips)
    blame(Promise::kTrip, joint, "shut itself off again and again, and no limit 0 was seen");
}

/// A goal moves by one step for each goal that was sent, or to where the joint is.
void ServoJudge::judgeStep(Joint joint, const hil::ServoState& before, const hil::ServoState& after,
                           std::uint32_t goals) {
  ++tally_.steps;
  const Servo& servo = servo_[index(joint)];
  // After a restart that was too short to be noticed it goes on from where it was, as in judgeShortOutage().
  const int lost = cycle_ - servo.lost_at <= kForgotten ? std::abs(after.goal - servo.lost_goal) : kTickMax;
  const int step = std::min(std::abs(after.goal - before.goal), lost);
  if (step > max_step_ - bound(Leniency::kRounding)) tolerate(Leniency::kRounding);
  if (step > max_step_ && goals > 1) tolerate(Leniency::kGoalAfterLimit);
  if (step > max_step_ * std::max(goals, 1U) && !acceptsGoal(joint, after.goal))
    blame(Promise::kStep, joint, "goal moved by " + std::to_string(step) + " ticks");
}

void ServoJudge::changed(Joint joint, hil::ServoEvent event, const hil::ServoState& before,
                         const hil::ServoState& /*after*/) noexcept {
  Servo& servo = servo_[index(joint)];
  note(joint, event == hil::ServoEvent::kPowerOn    ? "power on"
              : event == hil::ServoEvent::kPowerOff ? "power off"
                                                    : "trip");
  if (event == hil::ServoEvent::kPowerOn) servo.powered_at = cycle_;
  if (event == hil::ServoEvent::kPowerOff && before.pulls()) {
    servo.lost_at = cycle_;
    servo.lost_goal = before.goal;
    lost_under_torque_ = lost_under_torque_ || !robot_.board().device().servoPower();
  }
  if (event != hil::ServoEvent::kTripped) return;
  ++tally_.trips;
  servo.tripped_at = cycle_;
  if (servo.untrusted_until > cycle_) return;
  // One that is being taken over may have its torque from before: it is tried again, like any that comes under torque.
  const long on_since = std::max({servo.pulls_since, servo.driven_since, servo.torque_on_at});
  if (!servo.driven || cycle_ - on_since <= kGrace) {
    tolerate(servo.driven ? Leniency::kEarlyBit : Leniency::kEarlyTrips);
    if (++servo.early_trips > kEarlyTrips)
      blame(Promise::kTrip, joint, "shut itself off again and again when taken over");
    return;
  }
  tolerate(Leniency::kFirstTrip);
  if (++servo.trips > boundAs<int>(Leniency::kFirstTrip))
    blame(Promise::kTrip, joint, "shut itself off twice before it was believed");
}

double ServoJudge::truth(Joint joint) const {
  return robot_.board().body().state().joint[index(joint)].position_rad / kRadPerTick + kTickCentre;
}

bool ServoJudge::acceptsGoal(Joint joint, int goal) {
  const double off = std::abs(goal - truth(joint));
  const bool accepted = nearJoint(joint, goal);
  if (accepted && off > kNear) tolerate(Leniency::kRecentPosition);
  if (accepted && off > 1 && off <= kNear) tolerate(Leniency::kNearJoint);
  return accepted;
}

/// At the joint, or where the joint has been in the last cycles, moved into its range.
bool ServoJudge::nearJoint(Joint joint, int goal) const {
  const auto& position = servo_[index(joint)].position;
  const auto [lowest, highest] = std::ranges::minmax(position);
  const double now = truth(joint);
  const double low = row(joint).low, high = row(joint).high;
  // A servo that has just restarted has the goal where it is, in its range or not.
  if (std::abs(goal - now) <= kNear) return true;
  return goal >= std::clamp(std::min(lowest, now), low, high) - kNear &&
         goal <= std::clamp(std::max(highest, now), low, high) + kNear;
}

}  // namespace darwinop
