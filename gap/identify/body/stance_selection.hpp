// Which effect of the gyroscope the kinematics of the feet that stand show.
#pragma once

#include <optional>

#include "gap/identify/body/floor_selection.hpp"
#include "gap/identify/body/stance_gyro.hpp"

namespace darwinop::gap {

class StanceSelection {
 public:
  /// `about`: the model with all that clamped logs have shown.
  StanceSelection(const BodyCase& given, const MovingImu& imu, const FloorModel& about);

  /// The best effect of those of a sensor, if it earns its place in logs for fits and in held-out ones.
  [[nodiscard]] std::optional<FoundFloor> best(const std::vector<FloorEffect>& effects) const;
  /// The readings are less likely with this deviation than without.
  [[nodiscard]] bool refutes(const ImuDeviation& imu) const;

 private:
  ImuDeviation base_;
  StanceGyro fit_, held_out_;
};

}  // namespace darwinop::gap
