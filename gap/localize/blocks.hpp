// The loop cut open at one place after the other. Each piece is fed with what was measured at its entry and compared
// with what was measured at its exit; nothing is fitted. What is normal comes from the same cuts through roll-outs of
// the baseline with noise.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gap/localize/block_test.hpp"
#include "gap/localize/simulated_repeats.hpp"
#include "gap/plant/block.hpp"

namespace darwinop::gap {

enum class BlockVerdict : std::uint8_t { kClosed, kOpen, kNotTestable };
std::string_view name(BlockVerdict verdict);

struct BlockFinding {
  Block block{};
  BlockVerdict verdict = BlockVerdict::kNotTestable;
  std::string unit;                  // of rms and expected_rms: "ticks", "V", "mrad", "rad/s"
  double rms = 0, expected_rms = 0;  // NaN where it is not cut
  double significance = 0;           // standard deviations beyond what the baseline with noise gives
  double moved = 0;                  // how far the numbers of the model had to move inside their priors, the same unit
  std::string detail;                // why it cannot be cut, or what was seen
  std::vector<BlockResiduals> samples;  // a log of the evidence each; empty where it is not cut
};

struct Blocks {
  std::array<BlockFinding, kBlocks> all;        // in the order of Block
  std::optional<Block> first;                   // where to look first; nothing: all that was cut is closed
  double supply_ohm = 0, supply_ohm_sigma = 0;  // slope of the voltage against the servo's current; NaN: no voltage

  [[nodiscard]] const BlockFinding& of(Block block) const { return all[static_cast<std::size_t>(block)]; }
  [[nodiscard]] BlockFinding& of(Block block) { return all[static_cast<std::size_t>(block)]; }
};

Blocks findBlocks(const Case& given, const Hypothesis& baseline, const std::vector<std::size_t>& logs,
                  const SimulatedRepeats& copies);

}  // namespace darwinop::gap
