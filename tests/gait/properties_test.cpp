// Whatever file, wish and gyroscope: goals within the joints' ranges, and no jumps beyond what the engine is known for.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>

#include "managers/gait/engine.hpp"

namespace darwinop::gait {
namespace {

double within(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
}

Wish anyWish() {
  return {within(-1, 1), within(-1, 1), within(-1, 1), *rc::gen::arbitrary<bool>()};
}

Tilt anyTilt() {
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return {std::nan(""), std::nan("")};
    case 1:
      return {HUGE_VAL, -HUGE_VAL};
    default:
      return {within(-512, 512), within(-512, 512)};
  }
}

void requireInRange(const Goals& goals) {
  for (std::size_t i = 0; i < kWalkingJoints; ++i) {
    const JointRow& joint = kJointTable[i];
    RC_ASSERT(goals.tick[i] >= joint.low && goals.tick[i] <= joint.high);
    RC_ASSERT(std::isfinite(goals.rad(i)));
  }
}

RC_GTEST_PROP(Gait, StaysWithinTheJointsWhateverTheFileAsksFor, ()) {
  Parameters p;
  for (const ParameterRow& row : kParameters) p.*row.field = within(row.low, row.high);
  p.ik = *rc::gen::element(Ik::kFlawed, Ik::kExact);
  Engine engine{p};
  engine.start();
  for (int stretch = 0; stretch < 6; ++stretch) {
    const Wish wish = anyWish();
    const Tilt tilt = anyTilt();
    for (int call = 0; call < 100; ++call) requireInRange(engine.next(wish, tilt));
  }
}

RC_GTEST_PROP(Gait, ComesToRestWhateverTheFileAsksFor, ()) {
  Parameters p;
  for (const ParameterRow& row : kParameters) p.*row.field = within(row.low, row.high);
  Engine engine{p};
  engine.start();
  const int before = *rc::gen::inRange(0, 500);
  for (int call = 0; call < before; ++call) engine.next(anyWish(), {0, 0});
  engine.stop();
  int calls = 0;
  for (; engine.running() && calls < 2000; ++calls) engine.next(anyWish(), {0, 0});
  RC_ASSERT(calls <= 1.5 * p.period_time / kTickMs + 3);
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
  // 8 rad/s at a knee; a servo can do 12. A change of x begins where it makes no difference yet.
  RC_ASSERT(greatestJump(Parameters{}, wishes) <= 42);
}

RC_GTEST_PROP(Gait, JumpsNoFurtherThanTheReferenceWhenTheDirectionChanges, ()) {
  std::array<Wish, 4> wishes;
  for (Wish& wish : wishes) wish = anyWish();
  // Inherited: the feet open for a sidestep or a turn in a single call, at the top of a swing; golden_gait.csv has it.
  RC_ASSERT(greatestJump(Parameters{}, wishes) <= 330);
}

}  // namespace
}  // namespace darwinop::gait
