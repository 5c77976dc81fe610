// A servo that swings an arm, as a plant.
#pragma once

#include "gap/plant/plant.hpp"

namespace darwinop::gap {

class BenchPlant final : public Plant {
 public:
  [[nodiscard]] std::span<const Signal> signals() const override;
  [[nodiscard]] std::span<const Place> places() const override;
  [[nodiscard]] std::span<const Block> blocks() const override;
  void rollOut(const Case& given, std::size_t log, const Hypothesis& hypothesis, const RollOutOptions& options,
               Trace& trace) const override;
  [[nodiscard]] BlockResiduals blockResiduals(Block block, const Place& place, const Case& given, const Trajectory& log,
                                              const Hypothesis& hypothesis,
                                              const ShootingOptions& options) const override;
  [[nodiscard]] double supplyResistance(const Place& place, const Case& given,
                                        const std::vector<const Trajectory*>& logs,
                                        const Hypothesis& hypothesis) const override;
};

}  // namespace darwinop::gap
