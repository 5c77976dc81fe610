// Computes each cycle's commands from goals, walk and motion pages.
#include "window/drive/motion_planner.hpp"

#include <algorithm>
#include <cmath>

#include "core/counts.hpp"
#include "core/servo_limits.hpp"
#include "window/messages.hpp"

namespace darwinop::window {
namespace {

constexpr double kMaxStepMs = 500;                 // ms between two calls; the lease is lost after more
constexpr std::array<int, 2> kGetUpPages{10, 11};  // from lying on the front, on the back

body_player::Pose poseOf(const Sensors& seen) {
  return body_player::presentPose([&](Joint joint) -> const JointSensors& { return seen.joint[index(joint)]; },
                                  [](Joint) { return kUnknown; });
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
  commands_.joint[joint].setGoal(Rad{std::clamp(rad, -kPi, kPi)});
  commands_.joint[joint].setSpeedLimit(RadPerSec{speed});
}

void MotionPlanner::resetGains() {
  for (JointCommand& joint : commands_.joint) joint.setPGain(default_gain_);
}

const Commands& MotionPlanner::plan(DriveRequests requests, const Sensors& seen, double ms) {
  if (const auto gain = static_cast<double>(seen.safety.default_p_gain); std::isfinite(gain)) default_gain_ = gain;
  if (!requests.walk) walk_blocked_ = false;
  if (walk_blocked_) requests.walk.reset();
  const bool is_new = requests.page != 0 ||
                      std::ranges::any_of(requests.torque, [](const auto& limb) { return limb.has_value(); }) ||
                      (requests.walk && !status_.walks);
  if (is_new) status_.refused.clear();
  applyRequests(requests, seen, ms);
  const double followed_ms = following_.isGiven() ? std::clamp(ms, 0.0, kMaxStepMs) : 0;
  switchTorque(requests, seen);
  const bool begins_page = requests.page != 0 && beginPage(requests.page, seen);
  const bool begins_walk = requests.walk && !page_.isPlaying() && beginWalk(seen);
  applyGoals(requests);
  // A walk has a valid pose only after its first tick; at rest one tick per reading calibrates the gyroscope.
  advanceWalk(requests, seen, begins_walk || !walks() ? gait::kTickMs : followed_ms);
  advancePage(begins_page ? 0 : followed_ms);
  status_.walks = walks();
  status_.page = page_.isPlaying() ? page_.page() : 0;
  return commands_;
}

/// Rejects motions that the robot cannot follow, and aborts those it has not followed for a while: they would continue
/// far from the robot's pose.
void MotionPlanner::applyRequests(DriveRequests& requests, const Sensors& seen, double ms) {
  following_.update(seen.safety.state, ms);
  const bool follows = following_.isGiven(), fell = hasFallen(seen.safety);
  if (following_.isLost() && !atRest()) abortMotion(messages::kMotionAborted);
  if (fell && walks()) abortMotion("the robot has fallen");
  if (requests.walk && !follows && !walks()) requests.walk.reset();  // starts as soon as it follows
  if (requests.walk && (fell || page_.isPlaying())) {
    status_.refused = fell ? "the robot has fallen: get it up first" : messages::kPageIsPlaying;
    walk_blocked_ = true;
  }
  if (requests.page != 0) {
    const bool gets_up = std::ranges::find(kGetUpPages, requests.page) != kGetUpPages.end();
    if (!follows || gets_up != fell) {
      status_.refused = !follows ? messages::kRobotDoesNotFollow
                        : fell   ? "the robot has fallen: play a page that gets it up first"
                                 : messages::kPageRequiresAFall;
      requests.page = 0;
    }
  }
  if (walk_blocked_) requests.walk.reset();
}

/// All joints keep their goals.
void MotionPlanner::abortMotion(const char* why) {
  walk_.abandon();
  page_.brake();
  resetGains();
  walk_blocked_ = true;
  status_.refused = why;
}

/// Whether all joints of the limb report a recent position; otherwise rejects the request with the joint's name.
bool MotionPlanner::hasPositions(std::size_t limb, const Sensors& seen) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = seen.joint[i];
    if (static_cast<std::size_t>(kJointTable[i].chain) != limb) continue;
    if (joint.position.known() && !joint.motion.stale()) continue;
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
      commands_.joint[i].setTorque(!status_.limp[limb]);
      if (status_.limp[limb]) continue;
      commands_.joint[i].setTorqueLimit(NewtonMeter{kMaxTorqueNm});
      setGoal(i, seen.joint[i].position.value, kSliderSpeed);
    }
  }
}

/// True if a page has started.
bool MotionPlanner::beginPage(int page, const Sensors& seen) {
  if (!atRest()) {
    status_.refused = messages::kPageRequiresRest;
    return false;
  }
  if (status_.limp.any()) {
    status_.refused = "a page requires every limb: switch all torque on first";
    return false;
  }
  for (std::size_t limb = 0; limb < kLimbs; ++limb)
    if (!hasPositions(limb, seen)) return false;
  if (page_.start(page, poseOf(seen))) return true;
  status_.refused = "there is no page " + std::to_string(page);
  return false;
}

/// Starts a walk, or cancels its end. True if a walk has started.
bool MotionPlanner::beginWalk(const Sensors& seen) {
  const bool starts = !walks();
  if (starts) {
    std::bitset<kLimbs> needed = status_.limp;
    needed.reset(static_cast<std::size_t>(Chain::kHead));
    if (needed.any()) {
      status_.refused = messages::kWalkRequiresTorque;
      return false;
    }
    for (std::size_t i = 0; i < gait::kWalkingJoints; ++i)
      commands_.joint[i].setPGain(walk_.pGain(static_cast<Joint>(i)));
  }
  walk_.start(poseOf(seen));
  return starts;
}

/// Slider goals: all joints at rest, the head during a walk, none during a page.
void MotionPlanner::applyGoals(const DriveRequests& requests) {
  if (page_.isPlaying()) return;
  for (std::size_t i = !walks() ? 0 : gait::kWalkingJoints; i < kJoints; ++i)
    if (requests.goals[i] && !isLimp(i)) setGoal(i, requests.goals[i]->value, kSliderSpeed);
}

void MotionPlanner::advanceWalk(const DriveRequests& requests, const Sensors& seen, double ms) {
  if (!requests.walk && walks()) {
    if (walk_.walk().walking()) {
      walk_.stop();
    } else {  // moving to the stance: holds there as well
      walk_.abandon();
      resetGains();
    }
  }
  if (!walks() && page_.isPlaying()) return;
  const bool known = !seen.board.motion.stale();
  const auto count = [&](std::size_t axis) {
    return known ? countFrom(seen.board.gyro[axis].value, kGyroRegister) : kUnknown;
  };
  const body_player::GyroReading gyro{count(0), count(1), seen.cycle - seen.board.motion.age};
  if (!walk_.advance(ms, requests.walk.value_or(gait::WalkCommand{}), true, gyro)) return;
  for (std::size_t i = 0; i < gait::kWalkingJoints; ++i) setGoal(i, walk_.goal(static_cast<Joint>(i)), kMaxVelocity);
  if (!walks()) resetGains();
}

void MotionPlanner::advancePage(double ms) {
  if (!page_.isPlaying()) return;
  (void)page_.advance(ms);
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    setGoal(i, page_.goal(joint), kMaxVelocity);
    commands_.joint[i].setPGain(page_.pGain(joint));
  }
  if (!page_.isPlaying()) resetGains();
}

}  // namespace darwinop::window
