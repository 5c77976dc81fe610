// State machine of the safety layer as a pure function. guard_states.cpp derives the events from timers and conditions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/faults.hpp"

namespace darwinop::safety {

enum class Event : std::uint8_t {
  kBoardLost,         // the board has not replied for more than 5 cycles
  kBoardFound,        // the board replies
  kRelease,           // a fault, or the end of a session, requires torque off
  kKneel,             // a fault, or the end of a session, requires sitting down, then torque off
  kHold,              // a fault, or the end or stop of a session, requires holding the last goals
  kDriverCame,        // a new session begins
  kTakenOver,         // every joint that can be driven is driven; the move to the start pose is next
  kTakenOverInPlace,  // the same, without a move to the start pose
  kStartDone,         // the start pose is reached, or the move timed out
  kResume,            // the reason to hold is gone
  kKnelt,             // the robot sits
  kStiffSeen,         // no session drives, but a servo has torque, or may have
  kLimpSeen,          // no servo that replies has torque any more
  kCount
};
inline constexpr std::size_t kEvents = static_cast<std::size_t>(Event::kCount);
inline constexpr std::array<std::string_view, kEvents> kEventNames{
    "board_lost",          "board_found", "release", "kneel", "hold",       "driver_came", "taken_over",
    "taken_over_in_place", "start_done",  "resume",  "knelt", "stiff_seen", "limp_seen"};

/// State after `event`; `state` itself if the event has no effect in it.
constexpr State next(State state, Event event) {
  if (event == Event::kBoardLost) return State::kOffline;
  if (state == State::kOffline && event == Event::kStiffSeen) return State::kFoundStiff;
  if (state == State::kOffline) return event == Event::kBoardFound ? State::kLimp : state;
  if (event == Event::kRelease) return State::kLimp;
  if (event == Event::kKneel) return State::kKneeling;
  if (event == Event::kDriverCame) return State::kTakingOver;
  switch (state) {
    case State::kTakingOver:
      if (event == Event::kTakenOver) return State::kStarting;
      if (event == Event::kHold) return State::kHolding;
      if (event == Event::kStiffSeen) return State::kFoundStiff;
      return event == Event::kTakenOverInPlace ? State::kDriven : state;
    case State::kStarting:
      if (event == Event::kHold) return State::kHolding;
      return event == Event::kStartDone ? State::kDriven : state;
    case State::kDriven:
      return event == Event::kHold ? State::kHolding : state;
    case State::kHolding:
      return event == Event::kResume ? State::kDriven : state;
    case State::kKneeling:
      return event == Event::kKnelt ? State::kLimp : state;
    case State::kLimp:
      return event == Event::kStiffSeen ? State::kFoundStiff : state;
    case State::kFoundStiff:
      return event == Event::kLimpSeen ? State::kLimp : state;
    case State::kOffline:
    case State::kCount:
      return state;
  }
  return state;
}

static_assert(next(State::kOffline, Event::kDriverCame) == State::kOffline,
              "no session drives while the board is silent");
static_assert(next(State::kKneeling, Event::kResume) == State::kKneeling, "a kneel is not aborted by a request");
static_assert(next(State::kLimp, Event::kResume) == State::kLimp, "torque is switched on by a takeover only");

}  // namespace darwinop::safety
