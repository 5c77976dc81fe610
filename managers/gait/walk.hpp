// A whole walk: from any pose to the stance, standing still for the gyroscope, steps, and rest again.
#pragma once

#include "managers/gait/approach.hpp"
#include "managers/gait/engine.hpp"
#include "managers/gait/gyro_centre.hpp"

namespace darwinop::gait {

/// The two axes that keep balance, raw counts as the board gives them; NaN: not known. `fresh`: no tick has seen this
/// reading yet. A robot is read every 16 ms, for two ticks.
struct GyroCounts {
  double roll, pitch;
  bool fresh = true;
};

class Walk {
 public:
  /// For so many readings, which may have failed, it stands still to learn where the gyroscope rests.
  static constexpr int kPatience = 3 * GyroCentre::kSamples;

  explicit Walk(const Parameters& parameters) : engine_{parameters}, pose_{poseOf(engine_.goals())} {}

  /// From this pose; nothing happens while it walks, except that a stop is taken back.
  void start(const Pose& from);
  /// Rests at the end of the steps under way.
  void stop();
  /// Rests at once, wherever the joints are: somebody else has moved them. What the gyroscope showed stays known.
  void abandon();
  /// The next 8 ms. While it rests, a robot that is not moved tells where its gyroscope rests.
  void tick(const Wish& wish, bool balance, const GyroCounts& gyro);

  [[nodiscard]] bool resting() const { return phase_ == Phase::kRest; }
  [[nodiscard]] bool walking() const { return phase_ == Phase::kWalk; }
  [[nodiscard]] bool knowsBalance() const { return centre_.known(); }
  /// ms that remain until the robot stands in the stance.
  [[nodiscard]] double approachMs() const { return approach_.durationMs(); }
  /// rad; never faster than servos. At rest that of the last walk's end; before the first one, the stance.
  [[nodiscard]] const Pose& pose() const { return pose_; }
  [[nodiscard]] const Parameters& parameters() const { return engine_.parameters(); }

 private:
  enum class Phase { kRest, kApproach, kSettle, kWalk };

  void approach();
  void settle(bool balance, const GyroCounts& gyro);
  void learn(const GyroCounts& gyro);
  void walk(const Wish& wish, bool balance, const GyroCounts& gyro);

  Engine engine_;
  GyroCentre centre_;
  Approach approach_;
  Pose pose_;
  Phase phase_ = Phase::kRest;
  int waited_ = 0;  // readings
  bool stopping_ = false;
};

}  // namespace darwinop::gait
