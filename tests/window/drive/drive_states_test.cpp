// States of the drive thread against a literal table of every state and event, and the time limits.
#include "window/drive/drive_states.hpp"

#include <gtest/gtest.h>

#include <array>

#include "window/drive/drive_timers.hpp"

namespace darwinop::window {
namespace {

// Rows: states in order; columns: start_asked torque_on requests_missed finish_asked stop_asked stands failed released.
constexpr auto kDriveTable = [] {
  using enum DriveState;
  return std::array<std::array<DriveState, kDriveEvents>, kDriveStates>{{
      {kStarting, kFree, kFree, kFree, kFree, kFree, kFree, kFree},
      {kStarting, kDriving, kStarting, kHolding, kHolding, kStarting, kHolding, kFree},
      {kDriving, kDriving, kEnding, kEnding, kHolding, kDriving, kHolding, kFree},
      {kEnding, kEnding, kEnding, kEnding, kHolding, kHolding, kHolding, kFree},
      {kHolding, kHolding, kHolding, kHolding, kHolding, kHolding, kHolding, kFree},
  }};
}();

TEST(DriveStates, EveryPairOfStateAndEventLeadsWhereTheTableSays) {
  for (std::size_t s = 0; s < kDriveStates; ++s)
    for (std::size_t e = 0; e < kDriveEvents; ++e)
      EXPECT_EQ(next(static_cast<DriveState>(s), static_cast<DriveEvent>(e)), kDriveTable[s][e])
          << kDriveStateNames[s] << " + " << kDriveEventNames[e];
}

/// Time until the first event, in steps of 10 ms; at most a minute.
double timeToEvent(DriveTimers& timers, DriveState state, bool drives, bool walks, DriveEvent expected) {
  for (double ms = 10; ms <= 60'000; ms += 10)
    if (const auto event = timers.advance(state, drives, walks, 10)) {
      EXPECT_EQ(*event, expected);
      return ms;
    }
  return -1;
}

TEST(DriveTimers, TorqueMustComeOnWithinThirtySeconds) {
  DriveTimers timers;
  EXPECT_EQ(timers.advance(DriveState::kStarting, true, false, 0), DriveEvent::kTorqueOn);
  EXPECT_EQ(timeToEvent(timers, DriveState::kStarting, false, false, DriveEvent::kFailed), 30'010);
}

TEST(DriveTimers, ARobotAtRestIsHeldAtOnceAndOneThatWalksAfterItHasSettled) {
  DriveTimers timers;
  EXPECT_EQ(timers.advance(DriveState::kDriving, true, false, 10), std::nullopt);
  EXPECT_EQ(timers.advance(DriveState::kEnding, true, false, 0), DriveEvent::kStands);
  EXPECT_EQ(timers.advance(DriveState::kDriving, true, true, 10), std::nullopt);
  EXPECT_EQ(timers.advance(DriveState::kEnding, true, true, 1000), std::nullopt);
  EXPECT_EQ(timeToEvent(timers, DriveState::kEnding, true, false, DriveEvent::kStands), 300);
}

TEST(DriveTimers, AWalkThatDoesNotEndIsCutOffAfterSixSeconds) {
  DriveTimers timers;
  EXPECT_EQ(timers.advance(DriveState::kDriving, true, true, 100'000), std::nullopt)
      << "only the time of the end counts";
  EXPECT_EQ(timeToEvent(timers, DriveState::kEnding, true, true, DriveEvent::kStands), 6010);
}

TEST(DriveTimers, NoEventWithoutASessionOrDuringItsDrive) {
  for (const DriveState state : {DriveState::kFree, DriveState::kDriving, DriveState::kHolding}) {
    DriveTimers timers;
    EXPECT_EQ(timeToEvent(timers, state, false, false, DriveEvent::kCount), -1) << static_cast<int>(state);
  }
}

}  // namespace
}  // namespace darwinop::window
