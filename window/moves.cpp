#include "window/moves.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/counts.hpp"
#include "core/motor_control.hpp"
#include "core/present_goal.hpp"
#include "managers/motion/first_step.hpp"
#include "remote/protocol/units.hpp"

namespace darwinop::window {
namespace {

using M = remote::MotorSetting;

constexpr double kUsualGain = 4;  // Kp, 32 in the servo's register
constexpr double kRegisterPerKp = 8;
constexpr double kLongestTurn = 500;      // ms; after more the lease is gone
constexpr double kLongestPause = 300;     // ms; where a robot that has not followed goes on is far from here
constexpr std::uint32_t kOldReading = 4;  // cycles
constexpr std::array<int, 2> kPagesThatGetUp{10, 11};  // begin lying on the front, on the back

/// To the nearest tick.
std::int32_t tickOf(double rad) {
  return static_cast<std::int32_t>(std::lround(std::clamp(rad, -kPi, kPi) * 2048 / kPi));
}

std::array<double, kJoints> goalsOf(const Sensors& seen) {
  std::array<double, kJoints> pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = presentGoal(static_cast<Joint>(i), seen.joint[i], kUnknown);
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

bool Moves::isLimp(std::size_t joint) const {
  return doings_.limp[static_cast<std::size_t>(kJointTable[joint].chain)];
}

void Moves::say(std::size_t joint, double rad, double speed) {
  if (!std::isfinite(rad)) return;  // nobody knows: it keeps its goal
  M& setting = setting_[joint];
  setting.set |= M::kPosition | M::kVelocity;
  setting.position = std::clamp(tickOf(rad), -2048, 2047);
  setting.velocity = remote::wireFromVelocity(speed);
}

void Moves::gain(std::size_t joint, double kp) {
  setting_[joint].set |= M::kPid;
  setting_[joint].pid = {remote::wireFromGain(kp), 0, 0};
}

void Moves::usualGains() {
  for (std::size_t i = 0; i < kJoints; ++i) gain(i, kUsualGain);
}

remote::Request Moves::turn(Orders orders, const Sensors& seen, double ms) {
  for (std::size_t i = 0; i < kJoints; ++i) setting_[i] = {.joint = static_cast<Joint>(i)};
  if (!orders.walk) walk_is_barred_ = false;
  if (walk_is_barred_) orders.walk.reset();
  const bool asked = orders.page != 0 ||
                     std::ranges::any_of(orders.torque, [](const auto& limb) { return limb.has_value(); }) ||
                     (orders.walk && !doings_.walks);
  if (asked) doings_.refused.clear();
  heed(orders, seen, ms);
  if (lost_ms_ <= 0) carried_ms_ += std::clamp(ms, 0.0, kLongestTurn);
  switchTorque(orders, seen);
  if (orders.page != 0) beginPage(orders.page, seen);
  if (orders.walk && !player_.isPlaying()) beginWalk(seen);
  follow(orders);
  advanceWalk(orders, seen);
  advancePage();
  if (atRest()) carried_ms_ = 0;
  doings_.walks = !walk_.resting();
  doings_.page = player_.isPlaying() ? player_.page() : 0;
  remote::Request request;
  for (const M& setting : setting_)
    if (setting.set != 0) request.motors.add(setting);
  return request;
}

/// What the robot cannot follow is not begun; what it has not followed for a while is broken off, since it would go on
/// far from where the robot is then.
void Moves::heed(Orders& orders, const Sensors& seen, double ms) {
  const bool follows = seen.safety.state == State::kDriven, fell = hasFallen(seen.safety);
  lost_ms_ = follows ? 0 : lost_ms_ + std::max(ms, 1.0);
  if (lost_ms_ > kLongestPause && !atRest()) breakOff("broken off: the robot did not follow any more");
  if (fell && !walk_.resting()) breakOff("the robot has fallen");
  if (orders.walk && !follows && walk_.resting()) orders.walk.reset();  // as soon as it does
  if (orders.walk && (fell || player_.isPlaying())) {
    doings_.refused =
        fell ? "the robot has fallen: get it up first" : "a page is played: press again when it has ended";
    walk_is_barred_ = true;
  }
  if (orders.page != 0) {
    const bool gets_up = std::ranges::find(kPagesThatGetUp, orders.page) != kPagesThatGetUp.end();
    if (!follows || gets_up != fell) {
      doings_.refused = !follows ? "the robot does not follow yet"
                        : fell   ? "the robot has fallen: only pages that get it up are played"
                                 : "that page is for a robot that lies";
      orders.page = 0;
    }
  }
  if (walk_is_barred_) orders.walk.reset();
}

/// All joints keep the goals that they have.
void Moves::breakOff(const char* why) {
  walk_.abandon();
  player_.brake();
  lead_in_ = {};
  usualGains();
  walk_is_barred_ = true;
  doings_.refused = why;
}

/// Whether all its joints tell where they are. If not, it is said which does not.
bool Moves::knows(std::size_t limb, const Sensors& seen) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const JointSensors& joint = seen.joint[i];
    if (static_cast<std::size_t>(kJointTable[i].chain) != limb) continue;
    if (joint.position.known() && joint.motion.age < kOldReading) continue;
    doings_.refused = std::string{kJointTable[i].name} + " does not tell where it is";
    return false;
  }
  return true;
}

/// A limb that gets its torque back begins where it hangs.
void Moves::switchTorque(const Orders& orders, const Sensors& seen) {
  for (std::size_t limb = 0; limb < kLimbs; ++limb) {
    if (!orders.torque[limb] || *orders.torque[limb] == !doings_.limp[limb]) continue;
    if (!atRest()) {
      doings_.refused = "torque is switched while the robot neither walks nor plays a page";
      return;
    }
    if (doings_.limp[limb] && !knows(limb, seen)) return;
    doings_.limp[limb] = !*orders.torque[limb];
    for (std::size_t i = 0; i < kJoints; ++i) {
      if (static_cast<std::size_t>(kJointTable[i].chain) != limb) continue;
      if (!doings_.limp[limb]) say(i, seen.joint[i].position.value, kFastest);
      setting_[i].set |= M::kAvailableTorque;
      setting_[i].available_torque = doings_.limp[limb] ? 0 : remote::wireFromTorque(kMaxTorqueNm);
    }
  }
}

void Moves::beginPage(int page, const Sensors& seen) {
  if (!atRest()) {
    doings_.refused = "a page begins when the robot stands: it still walks, or plays one";
    return;
  }
  if (doings_.limp.any()) {
    doings_.refused = "a page needs every limb: switch all torque on first";
    return;
  }
  for (std::size_t limb = 0; limb < kLimbs; ++limb)
    if (!knows(limb, seen)) return;
  const std::array<double, kJoints> here = goalsOf(seen);
  const motion::Pose from = ticksOf(here);
  if (!player_.start(page, from)) {
    doings_.refused = "there is no page " + std::to_string(page);
    return;
  }
  carried_ms_ = 0;
  lead_in_ = {};
  const motion::Page& first = (*pages_)[static_cast<std::size_t>(page)];
  if (motion::firstStepSpeed(first, from) <= motion::kFastestFirstStep) return;
  // Too far for the page's own first step: led there first, as the motion manager does it.
  const motion::Pose target = motion::firstTarget(first, from);
  lead_in_ = {here, radOf(target)};
  player_.brake();
  (void)player_.start(page, target);
}

void Moves::beginWalk(const Sensors& seen) {
  if (walk_.resting()) {
    std::bitset<kLimbs> needed = doings_.limp;
    needed.reset(static_cast<std::size_t>(Chain::kHead));
    if (needed.any()) {
      doings_.refused = "walking needs both arms and both legs: switch their torque on first";
      return;
    }
    carried_ms_ = gait::kTickMs;  // before its first tick a walk's pose is not of here
    for (std::size_t i = 0; i < gait::kWalkingJoints; ++i)
      gain(i, gait::pGain(static_cast<Joint>(i), walk_.parameters()) / kRegisterPerKp);
  }
  const std::array<double, kJoints> here = goalsOf(seen);
  gait::Pose from{};
  std::copy_n(here.begin(), from.size(), from.begin());
  walk_.start(from);
}

/// Sliders: all joints at rest, the head while it walks, none during a page.
void Moves::follow(const Orders& orders) {
  if (player_.isPlaying()) return;
  for (std::size_t i = walk_.resting() ? 0 : gait::kWalkingJoints; i < kJoints; ++i)
    if (orders.goals[i] && !isLimp(i)) say(i, orders.goals[i]->value, kFastest);
}

void Moves::advanceWalk(const Orders& orders, const Sensors& seen) {
  const auto& gyro = seen.board.gyro;
  const bool known = seen.board.motion.age < kOldReading;
  const std::uint64_t before = std::exchange(reading_, seen.cycle - seen.board.motion.age);
  const auto count = [&](std::size_t axis) { return known ? countFrom(gyro[axis].value, kGyroRegister) : kUnknown; };
  gait::GyroCounts counts{count(0), count(1), reading_ != before};
  if (!orders.walk && !walk_.resting() && !walk_.walking()) {  // on its way to its feet: it holds there, too
    walk_.abandon();
    usualGains();
  } else if (!orders.walk && !walk_.resting()) {
    walk_.stop();
  }
  const bool moved = !walk_.resting();
  if (!moved && player_.isPlaying()) return;
  double left =
      moved ? carried_ms_ : static_cast<double>(gait::kTickMs);  // at rest it learns where the gyroscope rests
  for (; left >= gait::kTickMs; left -= gait::kTickMs) {
    walk_.tick(orders.walk.value_or(gait::Wish{}), true, counts);
    counts.fresh = false;
  }
  if (!moved) return;
  carried_ms_ = left;
  for (std::size_t i = 0; i < gait::kWalkingJoints; ++i) say(i, walk_.pose()[i], kMaxVelocity);
  if (walk_.resting()) usualGains();
}

void Moves::advancePage() {
  if (!player_.isPlaying()) return;
  for (; carried_ms_ >= motion::kTickMs; carried_ms_ -= motion::kTickMs) {
    if (!lead_in_.done())
      lead_in_.advance(motion::kTickMs);
    else if (!player_.tick())
      break;
  }
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double page = radFromTicks(player_.pose()[i]).value;
    say(i, lead_in_.done() ? page : lead_in_.at(i), kMaxVelocity);
    gain(i, player_.pGainRegister(static_cast<Joint>(i)) / kRegisterPerKp);
  }
  if (!player_.isPlaying()) usualGains();
}

}  // namespace darwinop::window
