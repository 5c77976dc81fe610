// The state machine of the robot as a pure function. Timers and conditions are turned into events elsewhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/faults.hpp"

namespace darwinop::safety {

enum class Event : std::uint8_t {
  kBoardLost,         // the board has not answered for more than 5 cycles
  kBoardFound,        // the board answers
  kRelease,           // a fault, or the end of a controller, asks for torque off
  kKneel,             // a fault, or the end of a controller, asks to sit down first
  kHold,              // a fault, or the end of a controller, asks to stay as it is
  kDriverCame,        // there is somebody to obey, or somebody else than before
  kTakenOver,         // every joint that can be driven is; the start pose comes next
  kTakenOverInPlace,  // the same, without a move to the start pose
  kStartDone,         // the start pose is reached, or given up
  kResume,            // the reason to hold has gone
  kKnelt,             // the robot sits
  kStiffSeen,         // nobody drives, and a servo holds its joint
  kLimpSeen,          // no answering servo holds its joint any more
  kCount
};
inline constexpr std::size_t kEvents = static_cast<std::size_t>(Event::kCount);
inline constexpr std::array<std::string_view, kEvents> kEventNames{
    "board_lost",          "board_found", "release", "kneel", "hold",       "driver_came", "taken_over",
    "taken_over_in_place", "start_done",  "resume",  "knelt", "stiff_seen", "limp_seen"};

/// Where `event` leads from `state`; `state` itself where the event means nothing.
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

static_assert(next(State::kOffline, Event::kDriverCame) == State::kOffline, "nobody drives a board that is silent");
static_assert(next(State::kKneeling, Event::kResume) == State::kKneeling, "a kneel is not aborted by a request");
static_assert(next(State::kLimp, Event::kResume) == State::kLimp, "torque comes on through a takeover only");

}  // namespace darwinop::safety
