// Balance feedback: what the gyroscope sees turns knees, ankles and hips against the fall.
#include "managers/gait/balance.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::gait {

namespace {

// Gains are those of servos with 1024 ticks; ours have four times as many.
constexpr int kFinerTicks = 4;
// Both ends of the board's converter; nothing real is beyond.
constexpr double kMostCounts = 1024;

int counts(double from_centre) {
  return static_cast<int>(std::clamp(from_centre, -kMostCounts, kMostCounts));
}

int correction(int from_centre, double gain) {
  return static_cast<int>(from_centre * gain * kFinerTicks);
}

}  // namespace

void addBalance(Goals& goals, const Tilt& tilt, const Parameters& p) {
  if (!std::isfinite(tilt.roll) || !std::isfinite(tilt.pitch)) return;
  const int roll = counts(tilt.roll), pitch = counts(tilt.pitch);
  const int hip = correction(roll, p.balance_hip_roll_gain), foot = correction(roll, p.balance_ankle_roll_gain);
  const int knee = correction(pitch, p.balance_knee_gain), ankle = correction(pitch, p.balance_ankle_pitch_gain);
  goals[Joint::kPelvR] -= hip;
  goals[Joint::kPelvL] -= hip;
  goals[Joint::kLegLowerR] -= knee;
  goals[Joint::kLegLowerL] += knee;
  goals[Joint::kAnkleR] += ankle;
  goals[Joint::kAnkleL] -= ankle;
  goals[Joint::kFootR] -= foot;
  goals[Joint::kFootL] -= foot;
}

}  // namespace darwinop::gait
