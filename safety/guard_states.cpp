// Part of the guard: derives events from faults and timers, and executes the actions of a state change.
#include <algorithm>

#include "safety/guard.hpp"

namespace darwinop::safety {
namespace {

// Cycles after which what is still unknown of a servo's torque stays unknown.
constexpr int kTwoRounds = 2 * kPollRound;
// After the robot sits: time to come to rest before it releases torque.
constexpr Nanos kRest{std::chrono::seconds{1}};

}  // namespace

Reaction Guard::demanded() const noexcept {
  const Reaction by_fault = faults_.reaction(faults_.worst());
  // A controller that ends because of the kneel must not make the robot drop half-way.
  if (!driver_.ended() || state_ == State::kKneeling) return by_fault;
  return std::max(by_fault, atExit(config_.on_exit));
}

std::optional<Event> Guard::findEvent() const noexcept {
  if (!board_.online()) return state_ == State::kOffline ? std::nullopt : std::optional{Event::kBoardLost};
  if (state_ == State::kOffline) return findEventOffline();
  const Reaction demand = demanded();
  if (demand >= Reaction::kLimp) return holds() ? Event::kRelease : findEventAtRest();
  if (demand == Reaction::kKneel && state_ != State::kKneeling) return holds() ? Event::kKneel : findEventAtRest();
  const bool wanted = driver_.present() && !holds_only_ && demand < Reaction::kKneel;
  if (driver_.came() && wanted) return Event::kDriverCame;
  return findEventOf(state_, wanted, demand == Reaction::kHold);
}

/// Servos keep their torque when the process that drives them dies. Before the first session, the robot counts as limp
/// only once every servo that replies has been polled. Without a board a session waits for this too: a poll may show
/// that the supply was interrupted under torque, and then a person has to act first.
std::optional<Event> Guard::findEventOffline() const noexcept {
  if (!board_.answersNow()) return std::nullopt;
  const bool polled = !board_.powered() || allKnown() || polling_for_ > kTwoRounds;
  if (board_.absent() && !polled) return std::nullopt;
  if (anyStiff() || holding_up_) return Event::kStiffSeen;
  return polled || (driver_.present() && !holds_only_) ? std::optional{Event::kBoardFound} : std::nullopt;
}

std::optional<Event> Guard::findEventAtRest() const noexcept {
  if (state_ == State::kTakingOver) return Event::kRelease;  // of a robot that is still limp
  if (state_ == State::kLimp && anyStiff()) return Event::kStiffSeen;
  if (state_ == State::kFoundStiff && !anyStiff() && (allKnown() || !board_.powered())) return Event::kLimpSeen;
  return std::nullopt;
}

bool Guard::anyStiff() const noexcept {
  return std::ranges::any_of(joints_, [](const JointGuard& j) { return j.stiff(); });
}

bool Guard::allKnown() const noexcept {
  return std::ranges::all_of(joints_, [](const JointGuard& j) { return j.torqueKnown(); });
}

/// Joints are held. A servo that missed a torque off does not count: the command is repeated to it alone.
bool Guard::holds() const noexcept {
  const auto left_stiff = [](const JointGuard& j) { return j.stiff() && !j.offOrdered(); };
  return (drives(state_) && !stillLimp()) || holding_up_ ||
         (state_ == State::kFoundStiff && std::ranges::any_of(joints_, left_stiff));
}

/// A session has come, but no joint has torque yet. If it ends now, nothing needs to be held or sat down.
bool Guard::stillLimp() const noexcept {
  return state_ == State::kTakingOver && !holding_up_ && allKnown() && !anyStiff();
}

std::optional<Event> Guard::findEventOf(State state, bool wanted, bool hold) const noexcept {
  const auto when = [](bool condition, Event event) { return condition ? std::optional{event} : std::nullopt; };
  const bool arrived = progress_ != PoseMove::Progress::kMoving;
  switch (state) {
    case State::kLimp:
    case State::kFoundStiff:
      return wanted ? Event::kDriverCame : findEventAtRest();
    case State::kTakingOver:
      if ((driver_.ended() || holds_only_) && stillLimp()) return Event::kRelease;  // whatever on_exit says
      if (holds_only_) return holding_up_ ? Event::kHold : Event::kStiffSeen;
      return when(takenOver(), in_place_ || started_ ? Event::kTakenOverInPlace : Event::kTakenOver);
    case State::kStarting:
      return hold || holds_only_ ? Event::kHold : when(arrived, Event::kStartDone);
    case State::kDriven:
      return when(hold, Event::kHold);
    case State::kHolding:
      return when(!hold && wanted, started_ ? Event::kResume : Event::kDriverCame);
    case State::kKneeling:
      if (wanted) return Event::kDriverCame;
      // A robot that lost its power is already down.
      return when(board_.powerLost() || (arrived && sat_for_ >= kRest), Event::kKnelt);
    case State::kOffline:
    case State::kCount:
      return std::nullopt;
  }
  return std::nullopt;
}

bool Guard::takenOver() const noexcept {
  if (!board_.powered()) return false;
  const auto settled = [](const JointGuard& j) { return j.channel().out() || j.channel().moving(); };
  const auto moving = [](const JointGuard& j) { return j.channel().moving(); };
  // No joint moves: not read yet, servos still starting, or all requested limp.
  const bool some = std::ranges::any_of(joints_, moving);
  if (std::ranges::all_of(joints_, settled) && some) return true;
  const bool waited = taking_over_for_ >= fromSeconds(config_.take_over_s);
  return waited && (some || std::ranges::all_of(joints_, settled));
}

/// While safety moves the robot by itself. A takeover that takes longer waits for power or servos, without limit: then
/// only a living controller keeps it waiting, for the robot would otherwise rise hours after its controller died. All
/// that begin a session publish in every cycle until it drives (webots/session.cpp, window/drive, apps/calibrate), and
/// `darwinop remote` gives the lease back after 0.5 s without a request.
bool Guard::excusesSilence() const noexcept {
  if (state_ == State::kStarting) return true;
  return state_ == State::kTakingOver && board_.powered() && taking_over_for_ < fromSeconds(config_.take_over_s);
}

void Guard::changeState(const Sensors& seen, Nanos dt) noexcept {
  runTimers(seen, dt);
  const auto event = findEvent();
  if (!event) return;
  act(*event);
  state_ = next(state_, *event);
}

void Guard::runTimers(const Sensors& seen, Nanos dt) noexcept {
  polling_for_ = state_ == State::kOffline && board_.answersNow() ? std::min(polling_for_ + 1, kTwoRounds + 1) : 0;
  if (state_ == State::kTakingOver && board_.powered()) taking_over_for_ += dt;
  if (state_ != State::kStarting && state_ != State::kKneeling) return;
  PoseMove::Mask moving;
  PoseMove::Angles position{};
  bool on_the_way = false;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointChannel& channel = joints_[i].channel();
    moving[i] = channel.moving();
    position[i] = seen.joint[i].position;
    on_the_way = on_the_way || (moving[i] && channel.goal() != start_pose_[i]);
  }
  progress_ = move_.update(moving, on_the_way, position, start_pose_, dt);
  sat_for_ = progress_ == PoseMove::Progress::kMoving ? Nanos{0} : sat_for_ + dt;
}

void Guard::act(Event event) noexcept {
  switch (event) {
    case Event::kRelease:
    case Event::kKnelt:
      perhaps_held_ = perhaps_held_ || drives(state_) || state_ == State::kFoundStiff || holding_up_;
      for (JointGuard& joint : joints_) joint.orderOff();
      holding_up_ = started_ = false;
      break;
    case Event::kDriverCame:
      for (JointGuard& joint : joints_) joint.restart();
      taking_over_for_ = Nanos{0};
      break;
    case Event::kKneel:
    case Event::kTakenOver:
      started_ = false;
      if (event == Event::kTakenOver) report_.missed_start.reset();
      move_.begin();
      progress_ = PoseMove::Progress::kMoving;
      sat_for_ = Nanos{0};
      break;
    case Event::kTakenOverInPlace:
      started_ = true;
      break;
    case Event::kStartDone:
      finishStart();
      break;
    case Event::kBoardLost:
    case Event::kBoardFound:
    case Event::kHold:
    case Event::kResume:
    case Event::kStiffSeen:
    case Event::kLimpSeen:
    case Event::kCount:
      break;
  }
}

void Guard::finishStart() noexcept {
  started_ = true;
  report_.missed_start = move_.missing();
  if (progress_ == PoseMove::Progress::kTimedOut) ++report_.start_timeouts;
  for (std::size_t i = 0; i < kJoints; ++i) joints_[i].requestIfNone(start_pose_[i]);
}

}  // namespace darwinop::safety
