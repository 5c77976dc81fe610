// Computes each cycle's commands from goals, walk and motion pages.
#include "window/motion_planner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/counts.hpp"
#include "core/goals/motor_control.hpp"
#include "core/goals/present_goal.hpp"
#include "managers/motion/first_step.hpp"
#include "remote/protocol/units.hpp"

namespace darwinop::window {
namespace {

using M = remote::MotorSetting;

constexpr double kDefaultGain = 4;  // Kp, 32 in the servo's register
constexpr double kRegisterPerKp = 8;
constexpr double kMaxStepMs = 500;          // ms between two calls; the lease is lost after more
constexpr double kMaxNotFollowingMs = 300;  // ms without following; after that the robot may be far from its goals
constexpr std::uint32_t kStaleAge = 4;      // cycles
constexpr std::array<int, 2> kGetUpPages{10, 11};  // from lying on the front, on the back

/// To the nearest tick.
std::int32_t tickOf(double rad) {
  return static_cast<std::int32_t>(std::lround(std::clamp(rad, -kPi, kPi) * 2048 / kPi));
}

std::array<double, kJoints> goalsOf(const Sensors& seen) {
  std::array<double, kJoints> pose{};
  for (std::size_t i = 0; i < kJoints; ++i)
    pose[i] = goals::presentGoal(static_cast<Joint>(i), seen.joint[i], kUnknown);
  return pose;
}

motion::Pose ticksOf(const std::array<double, kJoints>& pose) {
  motion::Pose ticks{};
  for (std::size_t i = 0; i < kJoints; ++i) ticks[i] = ticksFromRad(Rad{pose[i]});
  return ticks;
}

std::array<double, kJoints> radOf(const motion::Pose& ticks) {
  std::array<double, kJoints> pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = radFromTicks(ticks[i]).value;
  return pose;
}

bool hasFallen(const SafetyReport& safety) {
  const auto is_fall = [](const FaultRow& fault) { return fault.fault == Fault::kFell; };
  return safety.active[static_cast<std::size_t>(std::ranges::find_if(kFaultTable, is_fall) - kFaultTable.begin())];
}

}  // namespace

bool MotionPlanner::isLimp(std::size_t joint) const {
  return status_.limp[static_cast<std::size_t>(kJointTable[joint].chain)];
}

void MotionPlanner::setGoal(std::size_t joint, double rad, double speed) {
  if (!std::isfinite(rad)) return;  // unknown: the joint keeps its goal
  M& setting = settings_[joint];
  setting.set |= M::kPosition | M::kVelocity;
  setting.position = std::clamp(tickOf(rad), -2048, 2047);
  setting.velocity = remote::wireFromVelocity(speed);
}

void MotionPlanner::setGain(std::size_t joint, double kp) {
  settings_[joint].set |= M::kPid;
  settings_[joint].pid = {remote::wireFromGain(kp), 0, 0};
}

void MotionPlanner::resetGains() {
  for (std::size_t i = 0; i < kJoints; ++i) setGain(i, kDefaultGain);
}

remote::Request MotionPlanner::plan(DriveRequests requests, const Sensors& seen, double ms) {
  for (std::size_t i = 0; i < kJoints; ++i) settings_[i] = {.joint = static_cast<Joint>(i)};
  if (!requests.walk) walk_blocked_ = false;
  if (walk_blocked_) requests.walk.reset();
  const bool is_new = requests.page != 0 ||
                      std::ranges::any_of(requests.torque, [](const auto& limb) { return limb.has_value(); }) ||
                      (requests.walk && !status_.walks);
  if (is_new) status_.refused.clear();
  applyRequests(requests, seen, ms);
  if (not_following_ms_ <= 0) pending_ms_ += std::clamp(ms, 0.0, kMaxStepMs);
  switchTorque(requests, seen);
  if (requests.page != 0) beginPage(requests.page, seen);
  if (requests.walk && !player_.isPlaying()) beginWalk(seen);
  applyGoals(requests);
  advanceWalk(requests, seen);
  advancePage();
  if (atRest()) pending_ms_ = 0;
  status_.walks = !walk_.resting();
  status_.page = player_.isPlaying() ? player_.page() : 0;
  remote::Request request;
  for (const M& setting : settings_)
    if (setting.set != 0) request.motors.add(setting);
  return request;
}

/// Rejects motions that the robot cannot follow, and aborts those it has not followed for a while: they would continue
/// far from the robot's pose.
void MotionPlanner::applyRequests(DriveRequests& requests, const Sensors& seen, double ms) {
  const bool follows = seen.safety.state == State::kDriven, fell = hasFallen(seen.safety);
  not_following_ms_ = follows ? 0 : not_following_ms_ + std::max(ms, 1.0);
  if (not_following_ms_ > kMaxNotFollowingMs && !atRest()) abortMotion("aborted: the robot did not follow");
  if (fell && !walk_.resting()) abortMotion("the robot has fallen");
  if (requests.walk && !follows && walk_.resting()) requests.walk.reset();  // starts as soon as it follows
  if (requests.walk && (fell || player_.isPlaying())) {
    status_.refused =
        fell ? "the robot has fallen: get it up first" : "a motion page is playing: press again when it has ended";
    walk_blocked_ = true;
  }
  if (requests.page != 0) {
    const bool gets_up = std::ranges::find(kGetUpPages, requests.page) != kGetUpPages.end();
    if (!follows || gets_up != fell) {
      status_.refused = !follows ? "the robot does not follow yet"
                        : fell   ? "the robot has fallen: play a page that gets it up first"
                                 : "this page requires a fallen robot";
      requests.page = 0;
    }
  }
  if (walk_blocked_) requests.walk.reset();
}

/// All joints keep their goals.
void MotionPlanner::abortMotion(const char* why) {
  walk_.abandon();
  player_.brake();
  lead_in_ = {};
  resetGains();
  walk_blocked_ = true;
  status_.refused = why;
}

/// Whether all joints of the limb report a recent position; otherwise rejects the request with the joint's name.
bool MotionPlanner::hasPositions(std::size_t limb, const Sensors& seen) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = seen.joint[i];
    if (static_cast<std::size_t>(kJointTable[i].chain) != limb) continue;
    if (joint.position.known() && joint.motion.age < kStaleAge) continue;
    status_.refused = std::string{kJointTable[i].name} + " reports no position";
    return false;
  }
  return true;
}

/// A limb whose torque comes back starts at its present position.
void MotionPlanner::switchTorque(const DriveRequests& requests, const Sensors& seen) {
  for (std::size_t limb = 0; limb < kLimbs; ++limb) {
    if (!requests.torque[limb] || *requests.torque[limb] == !status_.limp[limb]) continue;
    if (!atRest()) {
      status_.refused = "torque can only be switched while the robot neither walks nor plays a page";
      return;
    }
    if (status_.limp[limb] && !hasPositions(limb, seen)) return;
    status_.limp[limb] = !*requests.torque[limb];
    for (std::size_t i = 0; i < kJoints; ++i) {
      if (static_cast<std::size_t>(kJointTable[i].chain) != limb) continue;
      if (!status_.limp[limb]) setGoal(i, seen.joint[i].position.value, kSliderSpeed);
      settings_[i].set |= M::kAvailableTorque;
      settings_[i].available_torque = status_.limp[limb] ? 0 : remote::wireFromTorque(kMaxTorqueNm);
    }
  }
}

void MotionPlanner::beginPage(int page, const Sensors& seen) {
  if (!atRest()) {
    status_.refused = "a page starts only when the robot stands still: it is walking or playing a page";
    return;
  }
  if (status_.limp.any()) {
    status_.refused = "a page requires every limb: switch all torque on first";
    return;
  }
  for (std::size_t limb = 0; limb < kLimbs; ++limb)
    if (!hasPositions(limb, seen)) return;
  const std::array<double, kJoints> here = goalsOf(seen);
  const motion::Pose from = ticksOf(here);
  if (!player_.start(page, from)) {
    status_.refused = "there is no page " + std::to_string(page);
    return;
  }
  pending_ms_ = 0;
  lead_in_ = {};
  const motion::Page& first = (*pages_)[static_cast<std::size_t>(page)];
  if (motion::firstStepSpeed(first, from) <= motion::kFastestFirstStep) return;
  // Too far for the page's first step: a lead-in moves there first, as in the motion manager.
  const motion::Pose target = motion::firstTarget(first, from);
  lead_in_ = {here, radOf(target)};
  player_.brake();
  (void)player_.start(page, target);
}

void MotionPlanner::beginWalk(const Sensors& seen) {
  if (walk_.resting()) {
    std::bitset<kLimbs> needed = status_.limp;
    needed.reset(static_cast<std::size_t>(Chain::kHead));
    if (needed.any()) {
      status_.refused = "walking requires both arms and both legs: switch their torque on first";
      return;
    }
    pending_ms_ = gait::kTickMs;  // the walk has a valid pose only after its first tick
    for (std::size_t i = 0; i < gait::kWalkingJoints; ++i)
      setGain(i, gait::pGain(static_cast<Joint>(i), walk_.parameters()) / kRegisterPerKp);
  }
  const std::array<double, kJoints> here = goalsOf(seen);
  gait::Pose from{};
  std::copy_n(here.begin(), from.size(), from.begin());
  walk_.start(from);
}

/// Slider goals: all joints at rest, the head during a walk, none during a page.
void MotionPlanner::applyGoals(const DriveRequests& requests) {
  if (player_.isPlaying()) return;
  for (std::size_t i = walk_.resting() ? 0 : gait::kWalkingJoints; i < kJoints; ++i)
    if (requests.goals[i] && !isLimp(i)) setGoal(i, requests.goals[i]->value, kSliderSpeed);
}

void MotionPlanner::advanceWalk(const DriveRequests& requests, const Sensors& seen) {
  const auto& gyro = seen.board.gyro;
  const bool known = seen.board.motion.age < kStaleAge;
  const std::uint64_t before = std::exchange(gyro_cycle_, seen.cycle - seen.board.motion.age);
  const auto count = [&](std::size_t axis) { return known ? countFrom(gyro[axis].value, kGyroRegister) : kUnknown; };
  gait::GyroCounts counts{count(0), count(1), gyro_cycle_ != before};
  if (!requests.walk && !walk_.resting() && !walk_.walking()) {  // moving to the stance: holds there as well
    walk_.abandon();
    resetGains();
  } else if (!requests.walk && !walk_.resting()) {
    walk_.stop();
  }
  const bool moved = !walk_.resting();
  if (!moved && player_.isPlaying()) return;
  double left =
      moved ? pending_ms_ : static_cast<double>(gait::kTickMs);  // at rest the walk calibrates the gyroscope's zero
  for (; left >= gait::kTickMs; left -= gait::kTickMs) {
    walk_.tick(requests.walk.value_or(gait::WalkCommand{}), true, counts);
    counts.fresh = false;
  }
  if (!moved) return;
  pending_ms_ = left;
  for (std::size_t i = 0; i < gait::kWalkingJoints; ++i) setGoal(i, walk_.pose()[i], goals::kMaxVelocity);
  if (walk_.resting()) resetGains();
}

void MotionPlanner::advancePage() {
  if (!player_.isPlaying()) return;
  for (; pending_ms_ >= motion::kTickMs; pending_ms_ -= motion::kTickMs) {
    if (!lead_in_.done())
      lead_in_.advance(motion::kTickMs);
    else if (!player_.tick())
      break;
  }
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double page = radFromTicks(player_.pose()[i]).value;
    setGoal(i, lead_in_.done() ? page : lead_in_.at(i), goals::kMaxVelocity);
    setGain(i, player_.pGainRegister(static_cast<Joint>(i)) / kRegisterPerKp);
  }
  if (!player_.isPlaying()) resetGains();
}

}  // namespace darwinop::window
