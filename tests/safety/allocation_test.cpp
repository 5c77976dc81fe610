// The guard allocates nothing after construction, whatever happens.
#include <gtest/gtest.h>

#include <limits>

#include "safety/fake_robot.hpp"
#include "safety/guard.hpp"
#include "support/allocation_probe.hpp"

namespace darwinop::safety {
namespace {

TEST(GuardAllocation, NothingIsAllocatedInAnyState) {
  Guard guard{Config{}};
  FakeRobot robot;
  Commands commands;
  commands.session = 1;
  std::size_t states_seen = 0;
  const long before = allocationsOfThisThread();
  for (int i = 0; i < 8000; ++i) {
    if (i < 3000) ++commands.sequence;
    commands.joint[3].setGoal(Rad{i % 7 == 0 ? std::numeric_limits<double>::quiet_NaN() : i * 1.0});
    commands.joint[4].setTorque(i / 100 % 2 == 0);
    robot.board_answers = i % 1000 > 20;
    robot.servo[7].error_bits = i > 2500 && i < 2600 ? error_bit::kOverload : std::uint8_t{0};
    robot.servo_power = i % 1500 > 5;
    const SafeCommands safe = guard.vet(commands, robot.seen);
    states_seen |= std::size_t{1} << static_cast<unsigned>(guard.report().state);
    robot.cycle(safe);
    if (i == 2800) ++commands.fault_resets;
  }
  EXPECT_EQ(allocationsOfThisThread(), before);
  EXPECT_EQ(states_seen, (std::size_t{1} << kStates) - 1) << "the test has not been through every state";
}

}  // namespace
}  // namespace darwinop::safety
