#include "gap/plant/bench/bench_plant.hpp"

#include <array>

#include "gap/plant/bench/block_residuals.hpp"
#include "gap/plant/bench/roll_out.hpp"

namespace darwinop::gap {

std::span<const Signal> BenchPlant::signals() const {
  static const std::array<Signal, kJointSignals> kAll{{{Signal::Kind::kPosition, "rad"},
                                                       {Signal::Kind::kSpeed, "rad/s"},
                                                       {Signal::Kind::kLoad, ""},
                                                       {Signal::Kind::kSupply, "V"}}};
  return kAll;
}

std::span<const Place> BenchPlant::places() const {
  static const std::array<Place, 1> kJoint{};
  return kJoint;
}

std::span<const Block> BenchPlant::blocks() const {
  static constexpr std::array kAll{Block::kCommand, Block::kController, Block::kSupply, Block::kPlant, Block::kSensor};
  return kAll;
}

void BenchPlant::rollOut(const Case& given, std::size_t log, const Hypothesis& hypothesis,
                         const RollOutOptions& options, Trace& trace) const {
  gap::rollOut(given, log, hypothesis, options, trace);
}

BlockResiduals BenchPlant::blockResiduals(Block block, const Place& /*place*/, const Case& given, const Trajectory& log,
                                          const Hypothesis& hypothesis, const ShootingOptions& options) const {
  switch (block) {
    case Block::kCommand:  // no signal is measured between the two
    case Block::kController:
      return controllerResiduals(given, log, hypothesis);
    case Block::kSupply:
      return supplyResiduals(given, log, hypothesis);
    case Block::kPlant:
      return shootingResiduals(given, log, hypothesis, options);
    case Block::kSensor:
      return sensorResiduals(log, hypothesis);
  }
  return {};
}

double BenchPlant::supplyResistance(const Place& /*place*/, const Case& given,
                                    const std::vector<const Trajectory*>& logs, const Hypothesis& hypothesis) const {
  return gap::supplyResistance(given, logs, hypothesis);
}

}  // namespace darwinop::gap
