// The state machine against a literal table of every state and event.
#include "safety/states.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

namespace darwinop::safety {
namespace {

using enum State;

// Rows: states in order; columns: board_lost board_found release kneel hold driver_came taken_over
// taken_over_in_place start_done resume knelt stiff_seen limp_seen.
constexpr std::array<std::array<State, kEvents>, kStates> kTable{{
    {kOffline, kLimp, kOffline, kOffline, kOffline, kOffline, kOffline, kOffline, kOffline, kOffline, kOffline,
     kFoundStiff, kOffline},
    {kOffline, kLimp, kLimp, kKneeling, kLimp, kTakingOver, kLimp, kLimp, kLimp, kLimp, kLimp, kFoundStiff, kLimp},
    {kOffline, kTakingOver, kLimp, kKneeling, kHolding, kTakingOver, kStarting, kDriven, kTakingOver, kTakingOver,
     kTakingOver, kFoundStiff, kTakingOver},
    {kOffline, kStarting, kLimp, kKneeling, kHolding, kTakingOver, kStarting, kStarting, kDriven, kStarting, kStarting,
     kStarting, kStarting},
    {kOffline, kDriven, kLimp, kKneeling, kHolding, kTakingOver, kDriven, kDriven, kDriven, kDriven, kDriven, kDriven,
     kDriven},
    {kOffline, kHolding, kLimp, kKneeling, kHolding, kTakingOver, kHolding, kHolding, kHolding, kDriven, kHolding,
     kHolding, kHolding},
    {kOffline, kKneeling, kLimp, kKneeling, kKneeling, kTakingOver, kKneeling, kKneeling, kKneeling, kKneeling, kLimp,
     kKneeling, kKneeling},
    {kOffline, kFoundStiff, kLimp, kKneeling, kFoundStiff, kTakingOver, kFoundStiff, kFoundStiff, kFoundStiff,
     kFoundStiff, kFoundStiff, kFoundStiff, kLimp},
}};

TEST(States, EveryPairOfStateAndEventLeadsWhereTheTableSays) {
  for (std::size_t s = 0; s < kStates; ++s)
    for (std::size_t e = 0; e < kEvents; ++e)
      EXPECT_EQ(next(static_cast<State>(s), static_cast<Event>(e)), kTable[s][e])
          << kStateNames[s] << " + " << kEventNames[e];
}

TEST(States, EveryStateCanBeReachedAndLeft) {
  std::set<State> reached;
  for (std::size_t s = 0; s < kStates; ++s) {
    bool left = false;
    for (std::size_t e = 0; e < kEvents; ++e) {
      const State to = next(static_cast<State>(s), static_cast<Event>(e));
      left = left || to != static_cast<State>(s);
      if (to != static_cast<State>(s)) reached.insert(to);
    }
    EXPECT_TRUE(left) << kStateNames[s];
  }
  EXPECT_EQ(reached.size(), kStates);
}

TEST(States, EventNamesAreDistinct) {
  const std::set<std::string_view> names(kEventNames.begin(), kEventNames.end());
  EXPECT_EQ(names.size(), kEvents);
  EXPECT_FALSE(names.contains(""));
}

}  // namespace
}  // namespace darwinop::safety
