// Whether each recording on the floor by itself is more likely with an effect that all of them together suggest.
#pragma once

#include <vector>

#include "gap/identify/body/floor_fit.hpp"
#include "gap/identify/body/log_agreement.hpp"

namespace darwinop::gap {

/// Of each log, in the order of FloorResiduals::logs: what it gains by the model that the noise is about.
std::vector<LogGain> gainsOf(const FloorResiduals& about_with, const FloorTraces& without,
                             const ImuDeviation& imu_without, const ImuDeviation& imu_with);

/// One of these logs refutes the effect, or all of them together lose by it.
bool refute(const std::vector<LogGain>& logs);

/// Held-out recordings on the floor under models that fits suggest.
class UnseenFloor {
 public:
  UnseenFloor(const BodyCase& given, const MovingImu& imu, const std::vector<Joint>& ignored)
      : given_{given}, imu_{imu}, ignored_{ignored} {}

  /// They contradict what `with` has beyond `without`. Noise, engine and priors are those about `with`.
  [[nodiscard]] bool refute(const FloorModel& without, const FloorModel& with) const;

 private:
  const BodyCase& given_;
  const MovingImu& imu_;
  const std::vector<Joint>& ignored_;
};

}  // namespace darwinop::gap
