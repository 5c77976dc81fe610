#include "gap/localize/block_effect.hpp"

#include <algorithm>
#include <cmath>

#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Root of the squares beyond those of noise.
double beyondNoise(double rms, double expected) {
  return std::sqrt(std::max(0.0, rms * rms - expected * expected));
}

/// A voltage that is off by a share changes the torque by it: the P law makes up for that by an error of the position.
double effectOfSupply(const Case& given, const Hypothesis& baseline, const std::vector<std::size_t>& logs,
                      const BlockFinding& supply) {
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < supply.samples.size(); ++i) {
    const Trajectory& log = given.logs[logs[i]];
    const BlockResiduals& samples = supply.samples[i];
    const double supply_v = supplyOf(given, log, baseline);
    for (std::size_t k = 0; k < samples.row.size(); ++k) {
      const double off_v = samples.residual[static_cast<Eigen::Index>(k)];
      if (std::isnan(off_v)) continue;
      const double load = log.load[samples.row[k]];
      const double duty = std::isnan(load) ? baseline.servo.duty_max : std::abs(load);
      const double gain = log.pRegisterAt(samples.row[k]) * baseline.servo.duty_per_kp_per_rad;  // 1/rad
      squares += gain > 0 ? std::pow(duty * off_v / supply_v / gain, 2) : 0, ++count;
    }
  }
  const double rms = std::sqrt(squares / std::max(count, 1.0));
  return supply.rms > 0 ? rms * beyondNoise(supply.rms, supply.expected_rms) / supply.rms : 0;
}

double effectOf(const Case& given, const Hypothesis& baseline, const std::vector<std::size_t>& logs,
                const BlockFinding& block) {
  if (block.block == Block::kSupply) return effectOfSupply(given, baseline, logs, block);
  const double size = beyondNoise(block.rms, block.expected_rms);
  if (block.unit == "ticks") return size * 2 * kPi / baseline.servo.ticks_per_rev;
  if (block.unit == "mrad") return 1e-3 * size;
  return 0;  // a register that nothing is controlled by
}

}  // namespace

void rankBlocks(const Case& given, const Hypothesis& baseline, const std::vector<std::size_t>& logs, Blocks& blocks) {
  double squares = 0;
  for (BlockFinding& block : blocks.all) {
    if (block.verdict != BlockVerdict::kOpen) continue;
    block.effect_rad = effectOf(given, baseline, logs, block);
    squares += block.effect_rad * block.effect_rad;
  }
  for (BlockFinding& block : blocks.all)
    if (block.verdict == BlockVerdict::kOpen && squares > 0)
      block.share = block.effect_rad * block.effect_rad / squares;
  const auto greatest = std::ranges::max_element(blocks.all, {}, &BlockFinding::share);  // the first of equals
  if (greatest->share > 0) blocks.first = greatest->block;
}

}  // namespace darwinop::gap
