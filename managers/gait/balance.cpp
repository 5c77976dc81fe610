// Balance feedback: corrects knees, ankles and hips in proportion to the gyroscope.
#include "managers/gait/balance.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::gait {

namespace {

// The gains are for servos with 1024 ticks per turn; MX-28 have 4096.
constexpr int kTickRatio = 4;
// Range of the board's converter.
constexpr double kMaxCounts = 1024;

int counts(double from_centre) {
  return static_cast<int>(std::clamp(from_centre, -kMaxCounts, kMaxCounts));
}

int correction(int from_centre, double gain) {
  return static_cast<int>(from_centre * gain * kTickRatio);
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
