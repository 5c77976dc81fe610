// Phases of the supervisor as a pure function.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace darwinop::supervisor {

enum class SupervisorPhase : std::uint8_t {
  kStarting,  // the runtime starts: no cycle so far
  kUp,        // its loop runs
  kBackOff,   // start failed; the next attempt comes after a pause
  kStopping,  // ending controller, then runtime
  kRescue,    // it died or hung; bringing the robot to rest
  kDown,      // at rest until the next command
  kOver,
  kCount
};
inline constexpr std::size_t kPhases = static_cast<std::size_t>(SupervisorPhase::kCount);
inline constexpr std::array<std::string_view, kPhases> kPhaseNames{"starting", "up",   "back_off", "stopping",
                                                                   "rescue",   "down", "over"};

enum class PhaseEvent : std::uint8_t {
  kStarted,      // a runtime process exists
  kFirstCycle,   // its loop runs
  kStartFailed,  // it could not be started, or ended before its first cycle
  kEnded,        // it ended by itself or as requested
  kLost,         // it died, hung, or did not end in time
  kRescueEnded,  // at rest, or given up after a stop command
  kStopAsked,    // the stop command
  kAllEnded,     // a stop was asked, and no process is left
  kCount
};
inline constexpr std::size_t kPhaseEvents = static_cast<std::size_t>(PhaseEvent::kCount);
inline constexpr std::array<std::string_view, kPhaseEvents> kPhaseEventNames{
    "started", "first_cycle", "start_failed", "ended", "lost", "rescue_ended", "stop_asked", "all_ended"};

/// A runtime can run in this phase.
constexpr bool hasRuntime(SupervisorPhase phase) {
  return phase == SupervisorPhase::kStarting || phase == SupervisorPhase::kUp || phase == SupervisorPhase::kStopping;
}

/// The phase after `event` in `phase`.
constexpr SupervisorPhase next(SupervisorPhase phase, PhaseEvent event) {
  const bool may_start =
      phase == SupervisorPhase::kStarting || phase == SupervisorPhase::kBackOff || phase == SupervisorPhase::kDown;
  switch (event) {
    case PhaseEvent::kStarted:
      return may_start ? SupervisorPhase::kStarting : phase;
    case PhaseEvent::kFirstCycle:
      return phase == SupervisorPhase::kStarting ? SupervisorPhase::kUp : phase;
    case PhaseEvent::kStartFailed:
      return may_start ? SupervisorPhase::kBackOff : phase;
    case PhaseEvent::kEnded:
      return hasRuntime(phase) ? SupervisorPhase::kDown : phase;
    case PhaseEvent::kLost:
      return hasRuntime(phase) ? SupervisorPhase::kRescue : phase;
    case PhaseEvent::kRescueEnded:
      return phase == SupervisorPhase::kRescue ? SupervisorPhase::kDown : phase;
    case PhaseEvent::kStopAsked:
      if (phase == SupervisorPhase::kBackOff) return SupervisorPhase::kDown;
      return hasRuntime(phase) ? SupervisorPhase::kStopping : phase;
    case PhaseEvent::kAllEnded:
      return phase == SupervisorPhase::kDown ? SupervisorPhase::kOver : phase;
    case PhaseEvent::kCount:
      break;
  }
  return phase;
}

static_assert(next(SupervisorPhase::kRescue, PhaseEvent::kStopAsked) == SupervisorPhase::kRescue,
              "the robot comes to rest first");

}  // namespace darwinop::supervisor
