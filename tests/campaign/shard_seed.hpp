// Seeds of the shards of a long campaign.
#pragma once

#include <cstdint>

#include "core/random.hpp"

namespace darwinop {

/// Seed of shard `shard` of a campaign. Seeds are often dates or counters: with `seed + shard`, two campaigns of
/// consecutive days would share all shards but one.
constexpr std::uint64_t shardSeed(std::uint64_t seed, std::uint64_t shard) noexcept {
  return splitMix(splitMix(seed + kSplitMixStep) + shard * kSplitMixStep);
}

}  // namespace darwinop
