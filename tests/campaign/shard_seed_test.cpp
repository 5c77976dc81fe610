// Two long campaigns with different seeds run different shards.
#include "campaign/shard_seed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace darwinop {
namespace {

constexpr std::uint64_t kShards = 1000;  // of 10^8 cycles

/// Shards that two of the campaigns with these seeds have in common.
std::size_t sharedShards(const std::vector<std::uint64_t>& seeds) {
  std::vector<std::uint64_t> all;
  for (const std::uint64_t seed : seeds)
    for (std::uint64_t shard = 0; shard < kShards; ++shard) all.push_back(shardSeed(seed, shard));
  std::ranges::sort(all);
  const auto last = std::unique(all.begin(), all.end());
  return all.size() - static_cast<std::size_t>(last - all.begin());
}

std::vector<std::uint64_t> consecutive(std::uint64_t first, std::uint64_t count) {
  std::vector<std::uint64_t> seeds;
  for (std::uint64_t i = 0; i < count; ++i) seeds.push_back(first + i);
  return seeds;
}

TEST(ShardSeeds, OfConsecutiveCampaignsAreAllDifferent) {
  for (const std::uint64_t first : {0ULL, 2026ULL, 20'261'101ULL, 1'726'712'263ULL, ~0ULL - 100})
    EXPECT_EQ(sharedShards(consecutive(first, 200)), 0U) << "from " << first;  // 19 900 pairs of seeds each
}

TEST(ShardSeeds, OfSeedsThatAreStepsOfTheGeneratorAreAllDifferent) {
  std::vector<std::uint64_t> seeds;
  for (std::uint64_t i = 0; i < 100; ++i) seeds.insert(seeds.end(), {i * kSplitMixStep, shardSeed(2026, i)});
  EXPECT_EQ(sharedShards(seeds), 0U);
}

TEST(ShardSeeds, OfARepeatedCampaignAreTheSame) {
  EXPECT_EQ(shardSeed(2026, 17), shardSeed(2026, 17));
  EXPECT_EQ(sharedShards({2026, 2026}), kShards);
}

}  // namespace
}  // namespace darwinop
