// Open-loop test of each block of the loop: its measured input goes in, its output is compared with the measured one.
// Nothing is fitted. The null distribution comes from simulated repeats of the baseline.
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
  std::string unit;                     // of rms and expected_rms: "ticks", "V", "mrad", "rad/s"
  double rms = 0, expected_rms = 0;     // NaN if not testable
  double significance = 0;              // standard deviations beyond simulated repeats
  double moved = 0;                     // significance of the moves of the baseline numbers, same unit
  double effect_rad = 0;                // of what is beyond noise: rms angle by which it moves the joint; open blocks
  double share = 0;                     // of the squares of that, over all open blocks
  std::string detail;                   // why it is not testable, or what was observed
  std::vector<BlockResiduals> samples;  // one for each log of the evidence; empty if not testable
};

/// Detail of the plant of law speed_p in logs that never have torque off.
inline constexpr const char* kPlantNeedsTorqueOff =
    "law speed_p: only torque off would show the plant, and it never is";

struct Blocks {
  std::array<BlockFinding, kBlocks> all;        // in the order of Block
  std::optional<Block> first;                   // open block of the greatest share; empty: every tested one is closed
  double supply_ohm = 0, supply_ohm_sigma = 0;  // slope of the voltage against the servo's current; NaN: no voltage

  [[nodiscard]] const BlockFinding& of(Block block) const { return all[static_cast<std::size_t>(block)]; }
  [[nodiscard]] BlockFinding& of(Block block) { return all[static_cast<std::size_t>(block)]; }
};

Blocks findBlocks(const Plant& plant, const Case& given, const Hypothesis& baseline,
                  const std::vector<std::size_t>& logs, const SimulatedRepeats& copies);

}  // namespace darwinop::gap
