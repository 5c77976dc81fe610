// Once it is made, a walk allocates nothing.
#include <gtest/gtest.h>

#include "managers/gait/walk.hpp"
#include "support/allocation_probe.hpp"

namespace darwinop::gait {
namespace {

TEST(GaitAllocation, NoPartOfAWalkAllocates) {
  Pose from{};
  Walk walk{Parameters{}};
  const long before = allocationsOfThisThread();
  for (int round = 0; round < 3; ++round) {
    walk.start(from);
    for (int tick = 0; tick < 1500; ++tick) walk.tick({0.5, -0.2, 1, false}, true, {512, 510});
    EXPECT_TRUE(walk.walking());
    walk.stop();
    while (!walk.resting()) walk.tick({}, true, {512, 510});
  }
  EXPECT_EQ(allocationsOfThisThread(), before);
}

}  // namespace
}  // namespace darwinop::gait
