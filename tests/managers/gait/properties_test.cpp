// Whatever file, wish and gyroscope: goals that are numbers, within the joints' ranges, never faster than a servo, and
// at rest when they should be.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>

#include "managers/gait/servo_speed.hpp"
#include "managers/gait/walk.hpp"

namespace darwinop::gait {
namespace {

/// One in three is an end of the range.
double within(double low, double high) {
  switch (*rc::gen::inRange(0, 6)) {
    case 0:
      return low;
    case 1:
      return high;
    default:
      return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
  }
}

Parameters anyParameters() {
  Parameters p;
  for (const ParameterRow& row : kParameters) p.*row.field = within(row.low, row.high);
  p.ik = *rc::gen::element(Ik::kFlawed, Ik::kExact);
  return p;
}

Wish anyWish() {
  return {within(-1, 1), within(-1, 1), within(-1, 1), *rc::gen::arbitrary<bool>()};
}

/// Silent, at rest, or thrown about.
GyroCounts anyGyro() {
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return {std::nan(""), std::nan("")};
    case 1:
      return {512, 512};
    default:
      return {within(0, 1023), within(0, 1023), *rc::gen::arbitrary<bool>()};
  }
}

/// As somebody may have left the joints.
Pose anyPose() {
  Pose pose{};
  for (std::size_t i = 0; i < kWalkingJoints; ++i)
    pose[i] = radFromTicks(static_cast<int>(within(kJointTable[i].low, kJointTable[i].high))).value;
  return pose;
}

/// The robot that gets the goals: remembers the last ones.
class Joints {
 public:
  explicit Joints(const Pose& at) : at_{at} {}
  void take(const Pose& goals) {
    for (std::size_t i = 0; i < kWalkingJoints; ++i) {
      const JointRow& joint = kJointTable[i];
      RC_ASSERT(std::isfinite(goals[i]));
      const int tick = ticksFromRad(Rad{goals[i]});
      RC_ASSERT(tick >= joint.low && tick <= joint.high);
      RC_ASSERT(std::abs(goals[i] - at_[i]) <= 12.26 * 0.008 + 1e-9);
    }
    at_ = goals;
  }
  [[nodiscard]] const Pose& at() const { return at_; }

 private:
  Pose at_;
};

RC_GTEST_PROP(Gait, AsksForWhatServosCanDoWhateverHappens, ()) {
  Walk walk{anyParameters()};
  Joints joints{anyPose()};
  if (*rc::gen::arbitrary<bool>())  // balance is known from the first step on
    for (int i = 0; i < GyroCentre::kSamples; ++i) walk.tick({}, true, {512, 512});
  for (int stretch = 0; stretch < 8; ++stretch) {
    const int what = stretch == 0 ? 0 : *rc::gen::inRange(0, 5);
    if (what == 0) walk.start(joints.at());
    if (what == 1) walk.stop();
    const Wish wish = anyWish();
    const bool balance = *rc::gen::arbitrary<bool>();
    GyroCounts gyro = anyGyro();
    const int ticks = *rc::gen::inRange(1, stretch == 0 ? 1500 : 150);
    for (int tick = 0; tick < ticks; ++tick) {
      const bool moves = !walk.resting();
      walk.tick(wish, balance, gyro);
      if (moves) joints.take(walk.pose());
      gyro.roll = 1023 - gyro.roll;  // there and back
    }
  }
  walk.stop();
  // To the stance, one and a half periods, and half a turn at the speed of a servo.
  int left = static_cast<int>((walk.approachMs() + 1.5 * walk.parameters().period_time + 256) / kTickMs) + 5;
  for (; !walk.resting() && left > 0; --left) {
    walk.tick(anyWish(), true, {512, 512});
    joints.take(walk.pose());
  }
  RC_ASSERT(walk.resting());
  const Parameters& p = walk.parameters();
  const bool stance_is_in_reach = goalsFor(feetAt(0, Timing{p}, Stride{{}, p}, p), p).has_value();
  if (stance_is_in_reach) RC_ASSERT(joints.at() == poseOf(Engine{p}.goals()));
}

/// Greatest step between two calls, ticks, over stretches of different wishes.
int greatestJump(const Parameters& p, const std::array<Wish, 4>& wishes) {
  const Tilt unseen{std::nan(""), std::nan("")};
  Engine engine{p};
  engine.start();
  int greatest = 0;
  Goals last = engine.goals();
  for (const Wish& wish : wishes) {
    for (int call = 0; call < 90; ++call) {
      const Goals goals = engine.next(wish, unseen);
      for (std::size_t i = 0; i < kWalkingJoints; ++i)
        greatest = std::max(greatest, std::abs(goals.tick[i] - last.tick[i]));
      last = goals;
    }
  }
  return greatest;
}

RC_GTEST_PROP(Gait, WalksForwardsAndBackwardsWithoutJumps, ()) {
  std::array<Wish, 4> wishes;
  for (Wish& wish : wishes) wish.x = within(-1, 1);
  // 8 rad/s at a knee, so the speed of servos changes nothing. A change of x begins where it makes no difference yet.
  RC_ASSERT(greatestJump(Parameters{}, wishes) <= 42);
}

}  // namespace
}  // namespace darwinop::gait
