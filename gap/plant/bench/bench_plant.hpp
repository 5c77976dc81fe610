// A servo that swings an arm, as a plant.
#pragma once

#include "gap/plant/plant.hpp"

namespace darwinop::gap {

/// Signals of a bench, and columns of its traces.
inline constexpr std::size_t kPositionSignal = 0;  // rad, of the encoder
inline constexpr std::size_t kSpeedSignal = 1;     // rad/s, of the arm; true
inline constexpr std::size_t kLoadSignal = 2;      // as the servo reports it, -1 to 1
inline constexpr std::size_t kSupplySignal = 3;    // V, at the servo
inline constexpr std::size_t kBenchSignals = 4;

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
};

}  // namespace darwinop::gap
