// The phases of the supervisor against a literal table of every phase and event.
#include "supervisor/phases.hpp"

#include <gtest/gtest.h>

#include <array>

namespace darwinop::supervisor {
namespace {

constexpr SupervisorPhase kStart = SupervisorPhase::kStarting, kUp = SupervisorPhase::kUp,
                          kWait = SupervisorPhase::kBackOff, kStop = SupervisorPhase::kStopping,
                          kRescue = SupervisorPhase::kRescue, kDown = SupervisorPhase::kDown,
                          kOver = SupervisorPhase::kOver;

// Rows: phases in order; columns: started first_cycle start_failed ended lost rescue_ended stop_asked all_ended.
constexpr std::array<std::array<SupervisorPhase, kPhaseEvents>, kPhases> kTable{{
    {kStart, kUp, kWait, kDown, kRescue, kStart, kStop, kStart},
    {kUp, kUp, kUp, kDown, kRescue, kUp, kStop, kUp},
    {kStart, kWait, kWait, kWait, kWait, kWait, kDown, kWait},
    {kStop, kStop, kStop, kDown, kRescue, kStop, kStop, kStop},
    {kRescue, kRescue, kRescue, kRescue, kRescue, kDown, kRescue, kRescue},
    {kStart, kDown, kWait, kDown, kDown, kDown, kDown, kOver},
    {kOver, kOver, kOver, kOver, kOver, kOver, kOver, kOver},
}};

TEST(SupervisorPhases, EveryPairOfPhaseAndEventLeadsWhereTheTableSays) {
  for (std::size_t p = 0; p < kPhases; ++p)
    for (std::size_t e = 0; e < kPhaseEvents; ++e)
      EXPECT_EQ(next(static_cast<SupervisorPhase>(p), static_cast<PhaseEvent>(e)), kTable[p][e])
          << kPhaseNames[p] << " + " << kPhaseEventNames[e];
}

TEST(SupervisorPhases, AStopLeadsToTheEndFromEveryPhase) {
  for (std::size_t p = 0; p < kPhases; ++p) {
    SupervisorPhase phase = next(static_cast<SupervisorPhase>(p), PhaseEvent::kStopAsked);
    for (const PhaseEvent event : {PhaseEvent::kEnded, PhaseEvent::kRescueEnded, PhaseEvent::kAllEnded})
      phase = next(phase, event);
    EXPECT_EQ(phase, SupervisorPhase::kOver) << kPhaseNames[p];
  }
}

}  // namespace
}  // namespace darwinop::supervisor
