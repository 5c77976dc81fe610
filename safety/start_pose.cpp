// Start pose and its check.
#include "safety/start_pose.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace darwinop::safety {
namespace {

constexpr std::uint32_t kRecent = 5;  // cycles

bool recent(const Freshness& freshness) {
  return freshness.ever() && freshness.age <= kRecent;
}

template <class... Numbers>
void addLine(std::string& text, const char* format, Numbers... numbers) {
  std::array<char, 200> line{};
  std::snprintf(line.data(), line.size(), format, numbers...);
  text += line.data();
}

void describeJoint(std::string& text, const StartPoseCheck::JointOff& off) {
  const JointRow& joint = row(off.joint);
  const std::string who =
      std::string{joint.name} + " (id " + std::to_string(joint.id) + ", " + std::string{joint.anatomical} + ")";
  if (!std::isfinite(off.off_rad)) {
    text += who + ": " + kPositionUnknown + "; check the cable that leads to it\n";
    return;
  }
  addLine(text, "%s: %+.1f deg (%+.3f rad) from the start pose, %.1f allowed; it is at %.3f rad, should be at %.3f\n",
          who.c_str(), off.off_rad / kRadPerDegree, off.off_rad, kStartPoseTolerance / kRadPerDegree,
          off.position.value, off.start.value);
}

}  // namespace

std::array<Rad, kJoints> startPose(const Config& config) noexcept {
  std::array<Rad, kJoints> pose{};
  for (std::size_t i = 0; i < kJoints; ++i)
    pose[i] = Rad{
        std::clamp(radFromTicks(kJointTable[i].start).value, config.range[i].low.value, config.range[i].high.value)};
  return pose;
}

StartPoseCheck checkStartPose(const Sensors& seen, const std::array<Rad, kJoints>& start) noexcept {
  StartPoseCheck result;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    if (!isLeg(joint)) continue;
    const Rad position = recent(seen.joint[i].motion) ? seen.joint[i].position : Rad{};
    const double off = position.value - start[i].value;
    // Tolerance of 0.001 ticks: exactly 230 ticks are allowed.
    if (!(std::abs(off) <= kStartPoseTolerance + kRadPerTick / 1000))
      result.off[result.off_count++] = {joint, position, start[i], off};
  }
  result.without_board = seen.board.absent;
  result.upright = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (recent(seen.board.motion)) result.acceleration[axis] = seen.board.accelerometer[axis];
    const double off = result.acceleration[axis].value - kUpright[axis];
    if (!(std::abs(off) <= kOrientationTolerance * 1.0001)) result.upright = false;
  }
  return result;
}

std::string describe(const StartPoseCheck& check) {
  if (check.off_count == 0 && check.upright) return "the robot is near its start pose and upright\n";
  std::string text;
  for (std::size_t i = 0; i < check.off_count; ++i) describeJoint(text, check.off[i]);
  if (check.upright) return text;
  if (check.without_board) return text + kOrientationUnknown + ": without a board nothing measures it\n";
  const auto& a = check.acceleration;
  if (!a[0].known() || !a[1].known() || !a[2].known())
    text += kOrientationUnknown + std::string{": the board has not reported its acceleration\n"};
  else
    addLine(text, "%s: acceleration %.2f %.2f %.2f m/s2, should be 0 0 %.2f, each within %.2f\n", kNotUpright,
            a[0].value, a[1].value, a[2].value, kUpright[2], kOrientationTolerance);
  return text;
}

}  // namespace darwinop::safety
