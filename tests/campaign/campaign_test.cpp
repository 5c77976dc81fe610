// Long runs under random faults: whatever happens on the line, to the robot and in the controller, the promises
// of the safety layer hold, nothing old passes for new, and all is well again soon after.
#include "campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <random>

namespace darwinop {
namespace {

std::uint64_t seedFromEnvironment() {
  if (const char* text = std::getenv("DARWINOP_SEED")) return std::strtoull(text, nullptr, 10);
  return std::random_device{}();
}

long cyclesFromEnvironment(long usual) {
  if (const char* text = std::getenv("DARWINOP_CAMPAIGN_CYCLES")) return std::strtol(text, nullptr, 10);
  return usual;
}

constexpr double kFaultsPerSecond = 2;

void fightAndReport(Campaign& campaign, std::uint64_t seed, hil::FaultKinds kinds) {
  const long cycles = cyclesFromEnvironment(10'000);
  campaign.fight(cycles, kFaultsPerSecond, kinds);
  EXPECT_EQ(campaign.failure(), "");
  EXPECT_GT(campaign.wire_judge.goalsSeen(), cycles);  // it did drive
  const ServoJudge::Tally& tally = campaign.servo_judge.tally();
  EXPECT_GT(tally.edges, cycles / 100);
  std::cout << "seed " << seed << ": " << campaign.readings << " fresh readings, " << campaign.wire_judge.goalsSeen()
            << " goals, " << campaign.robot.faults().begun() << " faults, torque came on " << tally.edges << " times, "
            << tally.trips << " trips, " << tally.releases << " releases, " << tally.damaged << " damaged writes\n"
            << report(campaign.tolerated());
}

TEST(Campaign, NothingStalePassesForFreshAndNoPromiseIsBroken) {
  const std::uint64_t seed = seedFromEnvironment();
  SCOPED_TRACE("DARWINOP_SEED=" + std::to_string(seed));
  Campaign campaign{seed};
  fightAndReport(campaign, seed, kindsThatKeepBytesWhole());
  EXPECT_EQ(campaign.wrong, 0);
}

TEST(Campaign, PromisesHoldWhenBytesAreLostAndDamagedToo) {
  const std::uint64_t seed = seedFromEnvironment();
  SCOPED_TRACE("DARWINOP_SEED=" + std::to_string(seed));
  Campaign campaign{seed};
  fightAndReport(campaign, seed, allKinds());
  EXPECT_LE(static_cast<double>(campaign.wrong), Campaign::wrongReadingsAllowed(false, campaign.readings));
}

TEST(Campaign, WithoutABoardNothingStalePassesForFreshEither) {
  const std::uint64_t seed = seedFromEnvironment();
  SCOPED_TRACE("DARWINOP_SEED=" + std::to_string(seed));
  Campaign campaign{seed, std::make_unique<FallingBody>(), false};
  fightAndReport(campaign, seed, kindsThatKeepBytesWhole());
  EXPECT_EQ(campaign.wrong, 0);
}

TEST(Campaign, WithoutABoardPromisesHoldWhenBytesAreLostAndDamagedToo) {
  const std::uint64_t seed = seedFromEnvironment();
  SCOPED_TRACE("DARWINOP_SEED=" + std::to_string(seed));
  Campaign campaign{seed, std::make_unique<FallingBody>(), false};
  fightAndReport(campaign, seed, allKinds());
  EXPECT_LE(static_cast<double>(campaign.wrong), Campaign::wrongReadingsAllowed(false, campaign.readings));
}

}  // namespace
}  // namespace darwinop
