// Plays a walk in SI units: goals and P gains of 18 joints for any step length.
#pragma once

#include <cstdint>

#include "managers/body_player/pose.hpp"
#include "managers/gait/walk.hpp"

namespace darwinop::body_player {

/// Raw gyroscope counts of the two balance axes; NaN: unknown. `cycle`: when the board was read.
struct GyroReading {
  double roll, pitch;
  std::uint64_t cycle;
};

class WalkPlayer {
 public:
  explicit WalkPlayer(const gait::Parameters& parameters) : walk_{parameters} {}

  /// Starts at `from`, see presentPose(): moves slowly to the stance first. During a walk it only cancels a stop.
  void start(const Pose& from);
  /// Applied between two steps; at rest at once.
  void setParameters(const gait::Parameters& parameters) { walk_.setParameters(parameters); }
  /// Those set last.
  [[nodiscard]] const gait::Parameters& parameters() const { return walk_.requestedParameters(); }
  /// Rests after the current steps.
  void stop() { walk_.stop(); }
  /// Rests immediately in any pose. Keeps the calibration of the gyroscope.
  void abandon() { walk_.abandon(); }
  /// Walks for `ms`; less than a tick is carried over to the next call. At rest it calibrates the gyroscope if the
  /// robot is not moved. True if the goals may have changed.
  bool advance(double ms, const gait::WalkCommand& command, bool balance, const GyroReading& gyro);

  [[nodiscard]] const gait::Walk& walk() const { return walk_; }
  /// rad; valid after the first advance() by a tick or more. `joint`: not of the head.
  [[nodiscard]] double goal(Joint joint) const { return walk_.pose()[index(joint)]; }
  /// Kp while walking. `joint`: not of the head.
  [[nodiscard]] double pGain(Joint joint) const;

 private:
  gait::Walk walk_;
  double carried_ms_ = 0;
  std::uint64_t gyro_cycle_ = 0;  // of the last reading used
};

}  // namespace darwinop::body_player
