// A register of whole degrees, and the heat behind it.
#include <gtest/gtest.h>

#include <cmath>

#include "gap/case/parts.hpp"

namespace darwinop::gap {
namespace {

double heatAt(double session_s) {
  return 43 - 18 * std::exp(-session_s / 30);
}

Case warmingUp(int logs) {
  Case session;
  for (int i = 0; i < logs; ++i) {
    Trajectory log;
    log.session_start_s = 9.0 * i;
    for (int row = 0; row < 440; ++row) {
      log.time_s.push_back(0.016 * row);
      log.temp_c.push_back(std::round(heatAt(log.session_start_s + 0.016 * row)));
    }
    session.logs.push_back(log);
  }
  return session;
}

double worst(const Trajectory& log, const std::vector<double>& smoothed) {
  double off = 0;
  for (std::size_t row = 0; row < log.rows(); ++row)
    off = std::max(off, std::abs(smoothed[row] - heatAt(log.session_start_s + log.time_s[row])));
  return off;
}

TEST(Warmth, FollowsTheServoBetweenTheStepsOfItsRegister) {
  Case session = warmingUp(8);
  smoothTemperatures(session);
  for (const Trajectory& log : session.logs) {
    EXPECT_LT(worst(log, log.warmth_c), 0.3) << log.session_start_s;
  }
  EXPECT_GT(worst(session.logs[0], session.logs[0].temp_c), 0.45) << "or there is nothing to smooth";
}

TEST(Warmth, LogsOfAnotherDayAreNotNeighbours) {
  Case session = warmingUp(2);
  for (double& temp : session.logs[1].temp_c) temp = 25;
  session.logs[1].session_start_s = session.logs[0].session_start_s;  // both begin at once: two sessions
  smoothTemperatures(session);
  for (const double warmth : session.logs[1].warmth_c) EXPECT_NEAR(warmth, 25, 1e-9);
}

// The runtime polls one servo a cycle.
TEST(Warmth, EveryRowOfAServoThatIsPolledNowAndThenHasATemperature) {
  Case session = warmingUp(8);
  for (Trajectory& log : session.logs)
    for (std::size_t row = 0; row < log.rows(); ++row)
      if (row % 20 != 7) log.temp_c[row] = std::nan("");
  smoothTemperatures(session);
  for (const Trajectory& log : session.logs) {
    for (const double warmth : log.warmth_c) ASSERT_FALSE(std::isnan(warmth));
    EXPECT_LT(worst(log, log.warmth_c), 0.5) << log.session_start_s;
  }
}

TEST(Warmth, WhatIsNotKnownStaysUnknown) {
  Case session = warmingUp(1);
  for (double& temp : session.logs[0].temp_c) temp = std::nan("");
  smoothTemperatures(session);
  for (const double warmth : session.logs[0].warmth_c) EXPECT_TRUE(std::isnan(warmth));
}

}  // namespace
}  // namespace darwinop::gap
