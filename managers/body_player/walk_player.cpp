// Plays a walk in SI units: goals and P gains of 18 joints for any step length.
#include "managers/body_player/walk_player.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/conversions.hpp"

namespace darwinop::body_player {

void WalkPlayer::start(const Pose& from) {
  if (walk_.resting()) carried_ms_ = 0;
  gait::Pose legs_and_arms{};
  std::copy_n(from.begin(), legs_and_arms.size(), legs_and_arms.begin());
  walk_.start(legs_and_arms);
}

bool WalkPlayer::advance(double ms, const gait::WalkCommand& command, bool balance, const GyroReading& gyro) {
  carried_ms_ += ms;
  if (carried_ms_ < gait::kTickMs) return false;
  // An unknown gyroscope counts as fresh in every call, so that the calibration times out.
  const bool known = std::isfinite(gyro.roll) && std::isfinite(gyro.pitch);
  gait::GyroCounts counts{gyro.roll, gyro.pitch};
  if (known) counts.fresh = std::exchange(gyro_cycle_, gyro.cycle) != gyro.cycle;
  const bool moves = !walk_.resting();
  for (; carried_ms_ >= gait::kTickMs; carried_ms_ -= gait::kTickMs) {
    walk_.tick(command, balance, counts);
    counts.fresh = false;
  }
  return moves;
}

double WalkPlayer::pGain(Joint joint) const {
  return gait::pGain(joint, walk_.parameters()) / kRegisterPerKp;
}

}  // namespace darwinop::body_player
