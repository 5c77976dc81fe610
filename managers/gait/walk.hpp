// State machine of a walk: approach to the stance, gyroscope calibration, steps, rest.
#pragma once

#include "managers/gait/approach.hpp"
#include "managers/gait/engine.hpp"
#include "managers/gait/gyro_centre.hpp"

namespace darwinop::gait {

/// Raw gyroscope counts of the two balance axes; NaN: unknown. `fresh`: a reading not used by an earlier tick. A robot
/// is read every 16 ms, so two ticks share a reading.
struct GyroCounts {
  double roll, pitch;
  bool fresh = true;
};

class Walk {
 public:
  /// Maximum number of readings, including failed ones, during the calibration.
  static constexpr int kMaxReadings = 3 * GyroCentre::kSamples;

  explicit Walk(const Parameters& parameters) : engine_{parameters}, pose_{poseOf(engine_.goals())} {}

  /// Starts from this pose. During a walk it only cancels a stop.
  void start(const Pose& from);
  /// Applied when both feet are down; at rest at once, for the stance of the next start.
  void setParameters(const Parameters& parameters);
  /// Rests after the current steps.
  void stop();
  /// Rests immediately in any pose, because another manager has moved the joints. Keeps the calibration.
  void abandon();
  /// The next 8 ms. At rest it calibrates the gyroscope if the robot is not moved.
  void tick(const WalkCommand& command, bool balance, const GyroCounts& gyro);

  [[nodiscard]] bool resting() const { return phase_ == Phase::kRest; }
  [[nodiscard]] bool walking() const { return phase_ == Phase::kWalk; }
  [[nodiscard]] bool isBalanceCalibrated() const { return centre_.known(); }
  /// Remaining time to the stance, ms.
  [[nodiscard]] double approachMs() const { return approach_.durationMs(); }
  /// rad, limited in speed. At rest the final pose of the last walk; before the first walk the stance.
  [[nodiscard]] const Pose& pose() const { return pose_; }
  [[nodiscard]] const Parameters& parameters() const { return engine_.parameters(); }
  /// Those that setParameters() set last, perhaps still to be applied.
  [[nodiscard]] const Parameters& requestedParameters() const { return engine_.requestedParameters(); }

 private:
  enum class Phase { kRest, kApproach, kCalibrate, kWalk };

  void approach();
  void calibrate(bool balance, const GyroCounts& gyro);
  void addSample(const GyroCounts& gyro);
  void walk(const WalkCommand& command, bool balance, const GyroCounts& gyro);

  Engine engine_;
  GyroCentre centre_;
  Approach approach_;
  Pose pose_;
  Phase phase_ = Phase::kRest;
  int waited_ = 0;  // readings
  bool stopping_ = false;
};

}  // namespace darwinop::gait
