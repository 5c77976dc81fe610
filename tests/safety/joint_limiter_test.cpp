// Limits for one joint.
#include "safety/joint_limiter.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace darwinop::safety {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr JointRange kLegRange{Rad{-1}, Rad{2}};

std::uint32_t count(const LimitHits& hits, Limit limit) {
  return hits[static_cast<std::size_t>(limit)];
}

TEST(JointLimiter, ClampsAGoalToTheRangeAndCountsIt) {
  LimitHits hits{};
  EXPECT_EQ(limitGoal(Rad{0.5}, Rad{0}, kLegRange, hits), Rad{0.5});
  EXPECT_EQ(limitGoal(Rad{2}, Rad{0}, kLegRange, hits), Rad{2});
  EXPECT_EQ(count(hits, Limit::kPosition), 0u);
  EXPECT_EQ(limitGoal(Rad{2.001}, Rad{0}, kLegRange, hits), Rad{2});
  EXPECT_EQ(limitGoal(Rad{-1e300}, Rad{0}, kLegRange, hits), Rad{-1});
  EXPECT_EQ(count(hits, Limit::kPosition), 2u);
}

TEST(JointLimiter, KeepsThePreviousGoalWhenTheNewOneIsNotFinite) {
  LimitHits hits{};
  for (const double bad : {kNan, kInf, -kInf}) EXPECT_EQ(limitGoal(Rad{bad}, Rad{0.25}, kLegRange, hits), Rad{0.25});
  EXPECT_EQ(count(hits, Limit::kNotFinite), 3u);
}

TEST(JointLimiter, StepsNoFurtherThanAllowedAndLandsExactly) {
  EXPECT_EQ(stepTowards(Rad{0}, Rad{1}, 0.25), Rad{0.25});
  EXPECT_EQ(stepTowards(Rad{0}, Rad{-1}, 0.25), Rad{-0.25});
  EXPECT_EQ(stepTowards(Rad{0.9}, Rad{1}, 0.25), Rad{1});
  EXPECT_EQ(stepTowards(Rad{1}, Rad{1}, 0.25), Rad{1});
}

TEST(JointLimiter, SpeedNeverBecomesNoLimit) {
  LimitHits hits{};
  EXPECT_NEAR(limitSpeed(RadPerSec{0}, RadPerSec{1}, hits).value, 0.01194, 1e-4);
  EXPECT_EQ(limitSpeed(RadPerSec{-3}, RadPerSec{1}, hits), RadPerSec{3}) << "the sign is ignored";
  EXPECT_EQ(count(hits, Limit::kSpeed), 0u);
  EXPECT_NEAR(limitSpeed(RadPerSec{100}, RadPerSec{1}, hits).value, 12.2127, 1e-3);
  EXPECT_EQ(count(hits, Limit::kSpeed), 1u);
  EXPECT_EQ(limitSpeed(RadPerSec{kNan}, RadPerSec{1}, hits), RadPerSec{1});
}

TEST(JointLimiter, TorqueLimitNeverLooksLikeAShutdown) {
  LimitHits hits{};
  EXPECT_GT(limitTorque(NewtonMeter{0}, NewtonMeter{1}, hits).value, 0.002);
  EXPECT_EQ(count(hits, Limit::kTorque), 0u);
  EXPECT_GT(limitTorque(NewtonMeter{-1}, NewtonMeter{1}, hits).value, 0.002);
  EXPECT_EQ(limitTorque(NewtonMeter{2.6}, NewtonMeter{1}, hits), NewtonMeter{2.5});
  EXPECT_EQ(count(hits, Limit::kTorque), 2u);
  EXPECT_EQ(limitTorque(NewtonMeter{kInf}, NewtonMeter{1}, hits), NewtonMeter{1});
}

TEST(JointLimiter, GainStaysInAByte) {
  LimitHits hits{};
  EXPECT_EQ(limitGain(4, 1, hits), 4);
  EXPECT_EQ(limitGain(-1, 1, hits), 0);
  EXPECT_EQ(limitGain(32, 1, hits), 31.75);
  EXPECT_EQ(limitGain(kNan, 1, hits), 1);
  EXPECT_EQ(count(hits, Limit::kGain), 2u);
}

}  // namespace
}  // namespace darwinop::safety
